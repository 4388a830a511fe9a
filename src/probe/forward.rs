//! How a probe hands on to the probe behind it what it doesn't see itself.

/// The methods of `Probe` with these names, each of which calls that of another probe: `forward!(self => Probe of self.probe; mark leave)`.
macro_rules! forward {
    ($this:ident => $trait:ident of $to:expr; $($method:ident)*) => { $(forward!(@$method $this $trait $to);)* };
    (@given $this:ident $trait:ident $to:expr) => {
        fn given<Q: $crate::probe::Quantity>(&mut $this, name: $crate::log::Name, value: Q) {
            $trait::given(&mut $to, name, value);
        }
    };
    (@mark $this:ident $trait:ident $to:expr) => {
        fn mark(&mut $this, decision: $crate::log::Decision) {
            $trait::mark(&mut $to, decision);
        }
    };
    (@bounds_tested $this:ident $trait:ident $to:expr) => {
        fn bounds_tested(&mut $this, count: u64) {
            $trait::bounds_tested(&mut $to, count);
        }
    };
    (@certifies $this:ident $trait:ident $to:expr) => {
        fn certifies(&$this) -> bool {
            $trait::certifies(&$to)
        }
    };
    (@decimals_of_products $this:ident $trait:ident $to:expr) => {
        fn decimals_of_products(&$this) -> Option<u32> {
            $trait::decimals_of_products(&$to)
        }
    };
    (@slack $this:ident $trait:ident $to:expr) => {
        fn slack(&$this, size: f64) -> f64 {
            $trait::slack(&$to, size)
        }
    };
    (@fallback $this:ident $trait:ident $to:expr) => {
        fn fallback(&mut $this) {
            $trait::fallback(&mut $to);
        }
    };
    (@rays_saved $this:ident $trait:ident $to:expr) => {
        fn rays_saved(&mut $this, why: $crate::probe::Saving, rays: u64) {
            $trait::rays_saved(&mut $to, why, rays);
        }
    };
    (@sees_parts $this:ident $trait:ident $to:expr) => {
        fn sees_parts(&$this) -> bool {
            $trait::sees_parts(&$to)
        }
    };
    (@part $this:ident $trait:ident $to:expr) => {
        fn part(&mut $this, emitter: $crate::log::plane::Emitter, color: glam::DVec3) {
            $trait::part(&mut $to, emitter, color);
        }
    };
    (@aim $this:ident $trait:ident $to:expr) => {
        fn aim(&mut $this, place: [f64; 2]) {
            $trait::aim(&mut $to, place);
        }
    };
    (@aimed $this:ident $trait:ident $to:expr) => {
        fn aimed(&mut $this) {
            $trait::aimed(&mut $to);
        }
    };
    (@enter $this:ident $trait:ident $to:expr) => {
        fn enter(&mut $this, step: $crate::log::Step) {
            $trait::enter(&mut $to, step);
        }
    };
    (@leave $this:ident $trait:ident $to:expr) => {
        fn leave(&mut $this) {
            $trait::leave(&mut $to);
        }
    };
}

pub(crate) use forward;
