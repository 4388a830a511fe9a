//! raywalk: a deterministic ray tracer. You can step through every value that it computes, in the terminal.
//!
//! Start reading at [`trace`], the recursion. A [`probe`] sees its values; a [`log`] records them.
//!
//! # Tracing a pixel and pinning it in a test
//!
//! ```
//! use raywalk::glam::DVec3;
//! use raywalk::record::{self, Arithmetic};
//! use raywalk::report::{Language, Style, text};
//! use raywalk::scene::{OpenError, Scene};
//! use raywalk::trace::query::Query;
//!
//! let scene: Scene = r#"{
//!     "format": "raywalk-scene/1",
//!     "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0], "vertical_fov": 40, "resolution": [3, 3] },
//!     "lights": [{ "name": "lamp", "point": { "position": [3, 4, 5] } }],
//!     "materials": { "red": { "diffuse": [0.8, 0.1, 0.1] } },
//!     "objects": [{ "name": "ball", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } }, "material": "red" }]
//! }"#.parse()?;
//!
//! // One ray.
//! let hit = Query::new(DVec3::new(0.0, 0.0, 5.0), DVec3::NEG_Z).nearest(&scene).expect("the ball is in front of the eye");
//! assert_eq!((hit.t, hit.point), (4.0, DVec3::Z));
//!
//! // One pixel: every value of it. `insta::assert_snapshot!(steps)` pins it.
//! let log = record::pixel(&scene, [1, 1], Arithmetic::F64);
//! let steps = text::text(Language::English, &log, Style::default());
//! assert!(steps.contains("nearest: ball"), "{steps}");
//! # Ok::<(), OpenError>(())
//! ```
//!
//! # A log of another renderer
//!
//! A renderer in any language writes lines of JSON (`docs/log.md`); one in Rust may take these types. `raywalk diff` then finds the first
//! value in which the two renderers differ.
//!
//! ```
//! use raywalk::glam::DVec3;
//! use raywalk::log::{Log, Name, RayKind, Step, Subject, file};
//! use raywalk::probe::{Probe, Recorder};
//! use raywalk::record::{self, Arithmetic};
//! use raywalk::scene::Scene;
//!
//! let scene = Scene::built_in("textbook")?;
//! let mut values = Recorder::default();
//! values.within(Step::Ray { kind: RayKind::Camera, depth: 0, split: 0 }, |values| {
//!     let point = values.note(Name::HitPoint, DVec3::new(4.0, 6.0, 8.0));
//!     values.within(Step::Shade { object: 0 }, |values| {
//!         values.within(Step::Light { light: 0, split: 0 }, |values| {
//!             // A mistake: this direction has no length of 1.
//!             values.note(Name::LightDirection, DVec3::new(9.0, 12.0, 16.0) - point);
//!         });
//!     });
//! });
//! let header = record::header(&scene, Subject::Pixel([160, 120]), Arithmetic::F64);
//! let mine = Log { header, events: values.finish([0.0; 3]) };
//! let lines = file::to_ndjson(&mine)?;
//! // raywalk diff raywalk.ndjson mine.ndjson --common: light.direction differs
//! assert_eq!(file::read(&lines)?.log, mine);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Where to find what
//!
//! | for | take |
//! |---|---|
//! | a scene: a file, a text, or made in code | [`scene::Scene`], [`scene::file::schema`] |
//! | one ray, what it hits, whether it is blocked | [`trace::query::Query`] |
//! | a pixel, a ray or a region as a log, in any arithmetic | [`record`] |
//! | logs: written, read, as a tree; quantities and their formulas | [`log`], [`log::file`] |
//! | a log for people, two logs compared | [`report::text`], [`report::diff`] |
//! | values as they are computed | [`probe::Probe`] |
//! | pictures | `render` (feature `program`) |
//!
//! # Features
//!
//! `program`, on by default, is the `raywalk` command and what only it needs: pictures and their formats, the viewer, studies. A renderer's
//! tests take `raywalk = { version = "0.1", default-features = false }`: scenes, the tracer, probes, logs and their texts, with fewer
//! than half of the crates.

// What only the studies of the program use is there without them, too.
#![cfg_attr(not(feature = "program"), allow(dead_code, unused_imports))]

/// Vectors and matrices, as this library's signatures have them.
pub use glam;

pub mod files;
pub mod geometry;
pub mod log;
pub mod probe;
pub mod record;
#[cfg(feature = "program")]
pub mod render;
pub mod report;
pub mod scene;
pub mod trace;

// The program and the tests of this package see these, too; they may change at any time.
#[doc(hidden)]
pub mod random;
#[doc(hidden)]
pub mod sampling;
#[cfg(feature = "program")]
#[doc(hidden)]
pub mod study;
#[doc(hidden)]
pub mod threads;
#[cfg(feature = "program")]
#[doc(hidden)]
pub mod tui;
