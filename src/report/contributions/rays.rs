//! What the rays of a log bring, from the eye on.

use super::LightPath;
use super::{Color, Contribution, Ended, Origin, Source, Why, times};
use crate::log::tree::path_of_child;
use crate::log::{Decision, Log, Name, RayKind, SkipReason, Step, Term, Tree, Value, What, scope};
use crate::report::evaluate;
use std::collections::HashMap;

/// A walk over the rays of a pixel.
pub(super) struct Walk<'a> {
    log: &'a Log,
    tree: &'a Tree,
    found: Vec<Contribution>,
    ended: Vec<Ended>,
    /// Rays to be followed yet: the node, its way, and the product of the weights before it.
    open: Vec<(usize, LightPath, Color)>,
    /// The numbers of the ways, by the way before and the last step.
    ways: HashMap<(u32, RayKind), u32>,
    /// The background's colour, once some step puts it in.
    background: Option<Color>,
}

/// What the weighted sum of a ray puts in.
struct Sum {
    local: Color,
    reflected: Color,
    transmitted: Color,
    incoming_reflected: Option<Color>,
    incoming_transmitted: Option<Color>,
}

impl<'a> Walk<'a> {
    pub(super) fn new(log: &'a Log, tree: &'a Tree) -> Walk<'a> {
        let ways = HashMap::new();
        Walk { log, tree, found: Vec::new(), ended: Vec::new(), open: Vec::new(), ways, background: None }
    }

    /// Follows a camera ray and all that it leads to.
    pub(super) fn follow(&mut self, ray: usize, weight: Color) {
        let before = LightPath { node: ray, number: 0, bounces: 0 };
        if let Some(kind) = self.tree.ray(ray) {
            let way = self.further(before, ray, kind);
            self.open.push((ray, way, weight));
        }
        while let Some((ray, way, weight)) = self.open.pop() {
            self.ray(ray, way, weight);
        }
    }

    /// A way that goes on by a ray.
    fn further(&mut self, before: LightPath, node: usize, kind: RayKind) -> LightPath {
        let next = self.ways.len() as u32 + 1;
        let number = *self.ways.entry((before.number, kind)).or_insert(next);
        let is_bounce = matches!(kind, RayKind::Reflected | RayKind::Transmitted);
        LightPath { node, number, bounces: before.bounces + usize::from(is_bounce) }
    }

    /// The path of a ray as people read it.
    fn path(&self, ray: usize) -> String {
        self.tree.shown_path(ray)
    }

    /// All that was found. A camera ray doesn't say what colour the background has: it is what the others leave of `result`.
    pub(super) fn finish(mut self, result: Option<Color>) -> (Vec<Contribution>, Vec<Ended>) {
        let is_background = |contribution: &Contribution| contribution.origin == Origin::Background;
        let (mut weight, mut others) = ([0.0; 3], [0.0; 3]);
        for contribution in &self.found {
            let (sum, part) = if is_background(contribution) {
                (&mut weight, &contribution.weight)
            } else {
                (&mut others, &contribution.color)
            };
            *sum = [0, 1, 2].map(|channel| sum[channel] + part[channel]);
        }
        let left = |channel: usize| {
            let rest = result.map_or(0.0, |result| result[channel]) - others[channel];
            if weight[channel] == 0.0 { 0.0 } else { rest / weight[channel] }
        };
        let background = self.background.unwrap_or_else(|| [0, 1, 2].map(left));
        for contribution in self.found.iter_mut().filter(|contribution| is_background(contribution)) {
            contribution.own = background;
            contribution.color = times(&contribution.weight, &background);
        }
        (self.found, self.ended)
    }

    fn ray(&mut self, ray: usize, way: LightPath, weight: Color) {
        let tree = self.tree;
        let marks: Vec<_> =
            tree.own_events(ray).filter_map(|event| Some((event, self.log.events[event].decision()?))).collect();
        if self.background.is_none() {
            let of_mark = |(event, _): &(usize, Decision)| triple(self.log.input(*event, Name::BackgroundColor));
            self.background = marks.iter().find_map(of_mark);
        }
        for (event, decision) in &marks {
            match decision {
                Decision::Background | Decision::Undefined { quantity: Name::RayDirection } => {
                    let (origin, source) = (Origin::Background, Some(Source::Background));
                    let path = self.path(ray);
                    self.found.push(Contribution::new(origin, (path, way), weight, [0.0; 3], source, Some(*event)));
                    return;
                }
                Decision::Nearest { .. }
                | Decision::Coincident { .. }
                | Decision::Immersed { .. }
                | Decision::Bent { .. } => {}
                Decision::Hit | Decision::Miss { .. } | Decision::Outside | Decision::Inside => {}
                Decision::Subdivided { .. } | Decision::Accepted { .. } | Decision::MoreSamples { .. } => {}
                Decision::Free
                | Decision::Occluded { .. }
                | Decision::Attenuated { .. }
                | Decision::Asked { .. }
                | Decision::Undefined { .. }
                | Decision::TotalInternalReflection
                | Decision::DepthLimit { .. }
                | Decision::LeakGuard { .. }
                | Decision::Rejected { .. }
                | Decision::Skipped { .. } => {
                    self.ended.push(Ended { path: self.path(ray), why: Why::Decided, event: *event })
                }
            }
        }
        let Some(sum) = self.sum(ray) else {
            let event = tree.nodes()[ray].events.start;
            return self.ended.push(Ended { path: self.path(ray), why: Why::LogEnds, event });
        };
        let leaks = |what: Term| marks.iter().any(|(_, decision)| *decision == Decision::LeakGuard { what });
        let [reflected_leaks, transmitted_leaks] = [Term::Reflected, Term::Transmitted].map(leaks);
        let kept = self.kept(ray);
        for child in tree.children(ray) {
            match tree.nodes()[child].step {
                Some(Step::Shade { object }) => self.surface(child, object, way, times(&weight, &sum.local)),
                Some(Step::Ray { kind, .. }) => {
                    let (leaks, factor, incoming) = match kind {
                        RayKind::Transmitted => (transmitted_leaks, sum.transmitted, sum.incoming_transmitted),
                        _ => (reflected_leaks, sum.reflected, sum.incoming_reflected),
                    };
                    if !leaks {
                        self.learn_background(child, incoming);
                        let way = self.further(way, child, kind);
                        self.open.push((child, way, times(&weight, &factor)));
                    }
                }
                Some(Step::Zone { what, .. }) => {
                    let factor = if what == Term::Transmitted { sum.transmitted } else { sum.reflected };
                    self.zone((ray, &kept), child, way, times(&weight, &factor));
                }
                _ => {}
            }
        }
    }

    /// The events of a ray that say how many directions of a blurred bounce were kept, and how many.
    fn kept(&self, ray: usize) -> Vec<(usize, f64)> {
        let kept = |event: usize| Some((event, self.log.input(event, Name::LobeKept)?.number()?));
        self.tree.own_events(ray).filter_map(kept).collect()
    }

    /// A direction of a blurred bounce: of all that were kept, each has the same share.
    fn zone(&mut self, (ray, kept): (usize, &[(usize, f64)]), zone: usize, way: LightPath, weight: Color) {
        let tree = self.tree;
        let end = tree.nodes()[zone].events.end;
        let kept = kept.get(kept.partition_point(|(event, _)| *event < end)).map(|(_, kept)| *kept);
        let after = tree.own_events_from(ray, end).next();
        let color = after.and_then(|event| triple(self.log.input(event, Name::LobeColor)));
        for event in tree.own_events(zone) {
            if matches!(self.log.events[event].decision(), Some(Decision::Rejected { .. })) {
                self.ended.push(Ended { path: self.path(ray), why: Why::Decided, event });
            }
        }
        for child in tree.children(zone) {
            if let (Some(kind), Some(kept)) = (tree.ray(child), kept) {
                self.learn_background(child, color);
                let way = self.further(way, child, kind);
                self.open.push((child, way, weight.map(|weight| weight / kept)));
            }
        }
    }

    /// The local model of a surface: its ambient light, and each of its lights.
    fn surface(&mut self, shade: usize, object: u32, way: LightPath, weight: Color) {
        let (log, tree) = (self.log, self.tree);
        let Some((event, name)) = super::local(log, tree, shade) else { return };
        let path = self.path(way.node);
        let of = |symbol| triple(scope::operand(&log.events, tree, event, symbol).map(|operand| operand.value));
        if let (Some(light), Some(part)) = (of(Name::AmbientLight.symbol()), of(Name::MaterialAmbient.symbol())) {
            let own = times(&light, &part);
            if own != [0.0; 3] {
                let (origin, source) = (Origin::Ambient { object }, Some(Source::Ambient));
                self.found.push(Contribution::new(origin, (path.clone(), way), weight, own, source, Some(event)));
            }
        }
        for child in tree.children(shade) {
            if let Some(Step::Light { light, split }) = tree.nodes()[child].step {
                let kind = RayKind::Shadow { light };
                let path = path_of_child(&path, Step::Ray { kind, depth: 0, split });
                let way = self.further(way, way.node, kind);
                self.light(child, (light, object), (path, way), weight, name);
            }
        }
    }

    fn light(
        &mut self,
        node: usize,
        (light, object): (u32, u32),
        (path, mut way): (String, LightPath),
        weight: Color,
        local: Name,
    ) {
        let tree = self.tree;
        let shadow = tree.children(node).find(|child| tree.ray(*child).is_some());
        let marks = tree.own_events(node).chain(shadow.into_iter().flat_map(|ray| tree.own_events(ray)));
        let decided = marks.filter_map(|event| {
            let why = match self.log.events[event].decision()? {
                Decision::Occluded { .. } => Why::Blocked { light },
                Decision::Skipped { why: SkipReason::Behind, .. } => Why::LightBehind { light },
                // The light brings its other terms.
                Decision::Skipped { why: SkipReason::ZeroTerm, .. } => return None,
                Decision::LeakGuard { .. } | Decision::Skipped { .. } | Decision::Undefined { .. } => Why::Decided,
                _ => return None,
            };
            Some((event, why))
        });
        // That a ray is blocked says more than that the rest of it is skipped.
        let ended = decided.min_by_key(|(_, why)| *why == Why::Decided);
        if let Some((event, why)) = ended {
            return self.ended.push(Ended { path, why, event });
        }
        let noted = tree
            .own_events(node)
            .find(|event| matches!(self.log.events[*event].what, What::Note { name: Name::ShadeNDotL, .. }));
        let is_free = |event: usize| self.log.events[event].decision() == Some(Decision::Free);
        if shadow.is_none() && !tree.own_events(node).any(is_free) {
            let event = noted.unwrap_or(tree.nodes()[node].events.start);
            return self.ended.push(Ended { path, why: Why::LightBehind { light }, event });
        }
        let own = evaluate::term_of_light(self.log, tree, node, local);
        let source = Some(self.scattering(node, noted));
        let event = tree.nodes()[node].events.start;
        way.node = shadow.unwrap_or(way.node);
        self.found.push(Contribution::new(
            Origin::Light { light, object },
            (path, way),
            weight,
            own,
            source,
            Some(event),
        ));
    }

    /// Which terms of the local model the light at this node goes through.
    fn scattering(&self, light: usize, n_dot_l: Option<usize>) -> Source {
        let is_behind = n_dot_l.is_some_and(|event| match self.log.events[event].what {
            What::Note { value: Value::Number(x), .. } => x < 0.0,
            _ => false,
        });
        let is_there = |symbol| {
            let operand = scope::operand_of_light(&self.log.events, self.tree, light, symbol);
            triple(operand.map(|operand| operand.value)).is_some_and(|color| color != [0.0; 3])
        };
        let diffuse = !is_behind && is_there(Name::MaterialDiffuse.symbol());
        Source::Light { diffuse, specular: is_behind || is_there(Name::MaterialSpecular.symbol()) }
    }

    /// The weighted sum at the end of a ray.
    fn sum(&self, ray: usize) -> Option<Sum> {
        let tree = self.tree;
        let combine = tree.children(ray).filter(|child| tree.nodes()[*child].step == Some(Step::Combine)).last()?;
        let given = |name| triple(tree.own_events(combine).find_map(|event| self.log.input(event, name)));
        let reflected = given(Name::WeightReflected)?;
        // What scales the reflected light beside its weight, where the scene says so.
        let scale = given(Name::MaterialSpecular).unwrap_or([1.0; 3]);
        Some(Sum {
            local: given(Name::WeightLocal)?,
            reflected: [0, 1, 2].map(|channel| reflected[channel] * scale[channel]),
            transmitted: given(Name::WeightTransmitted)?,
            incoming_reflected: given(Name::IncomingReflected),
            incoming_transmitted: given(Name::IncomingTransmitted),
        })
    }

    /// A bounce that hits nothing brings the background, which the step after it puts in.
    fn learn_background(&mut self, ray: usize, incoming: Option<Color>) {
        let is_background = |event: usize| self.log.events[event].decision() == Some(Decision::Background);
        if self.background.is_none() && self.tree.own_events(ray).any(is_background) {
            self.background = incoming;
        }
    }
}

fn triple(value: Option<Value>) -> Option<Color> {
    match value? {
        Value::Triple(triple) => Some(triple),
        Value::Number(x) => Some([x; 3]),
    }
}
