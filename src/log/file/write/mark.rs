//! Decisions in a line of a log.

use super::{string, text, triple};
use crate::log::event::Decision;
use crate::log::header::Header;

/// The decision's name and fields, without the braces around them and after the opening quote.
pub(super) fn mark(out: &mut Vec<u8>, header: &Header, decision: &Decision) {
    match decision {
        Decision::Hit => text(out, "hit\":{"),
        Decision::Miss { why } => text(out, &format!("miss\":{{\"why\":\"{}\"", why.word())),
        Decision::Outside => text(out, "outside\":{"),
        Decision::Inside => text(out, "inside\":{"),
        Decision::Nearest { object } => {
            text(out, "nearest\":{\"object\":");
            string(out, header.object(*object));
        }
        Decision::Coincident { object, triangle } => {
            text(out, "coincident\":{\"object\":");
            string(out, header.object(*object));
            if let Some(triangle) = triangle {
                text(out, &format!(",\"triangle\":{triangle}"));
            }
        }
        Decision::Immersed { object } => {
            text(out, "immersed\":{\"object\":");
            string(out, header.object(*object));
        }
        Decision::Bent { what } => text(out, &format!("bent\":{{\"what\":\"{}\"", what.word())),
        Decision::Background => text(out, "background\":{"),
        Decision::Free => text(out, "free\":{"),
        Decision::Occluded { object } => {
            text(out, "occluded\":{\"object\":");
            string(out, header.object(*object));
        }
        Decision::Attenuated { object, factor } => {
            text(out, "attenuated\":{\"object\":");
            string(out, header.object(*object));
            text(out, ",\"factor\":");
            triple(out, factor);
        }
        Decision::Undefined { quantity } => text(out, &format!("undefined\":{{\"quantity\":\"{}\"", quantity.key())),
        Decision::TotalInternalReflection => text(out, "total_internal_reflection\":{"),
        Decision::DepthLimit { what } => text(out, &format!("depth_limit\":{{\"what\":\"{}\"", what.word())),
        Decision::LeakGuard { what } => text(out, &format!("leak_guard\":{{\"what\":\"{}\"", what.word())),
        Decision::Rejected { what } => text(out, &format!("rejected\":{{\"what\":\"{}\"", what.word())),
        Decision::Skipped { what, why } => {
            text(out, &format!("skipped\":{{\"what\":\"{}\",\"why\":\"{}\"", what.word(), why.word()));
        }
        Decision::Subdivided { cell, why, object } => {
            text(out, "subdivided\":{\"cell\":");
            triple(out, cell);
            text(out, &format!(",\"why\":\"{}\"", why.word()));
            if let Some(object) = object {
                text(out, ",\"object\":");
                string(out, header.object(*object));
            }
        }
        Decision::Accepted { cell, why } => {
            text(out, "accepted\":{");
            if let Some(cell) = cell {
                text(out, "\"cell\":");
                triple(out, cell);
                text(out, ",");
            }
            text(out, &format!("\"why\":\"{}\"", why.word()));
        }
        Decision::Asked { light, why, points, object } => {
            text(out, "asked\":{\"light\":");
            string(out, header.light(*light));
            text(out, &format!(",\"why\":\"{}\",\"points\":{points}", why.word()));
            if let Some(object) = object {
                text(out, ",\"object\":");
                string(out, header.object(*object));
            }
        }
        Decision::MoreSamples { from, to } => text(out, &format!("more_samples\":{{\"from\":{from},\"to\":{to}")),
    }
}
