//! The bus over time as an inline SVG picture. Its looks are classes of the page's style.

use std::fmt::Write as _;

use can_wire::{EventKind, Level, Signal, Time};

use crate::{
    Story,
    moments::{BUS_OFF, PASSIVE, WARNING, milliseconds, place},
    play::MOTOR,
    story::{Attempt, Deed, Doing, Fate, Span},
};

const WIDTH: f64 = 1200.0;
const LEFT: f64 = 74.0;
const RIGHT: f64 = 14.0;
/// Height of the time axis, of the row of parts, of the row of faults, of the bus and of a node.
const AXIS: f64 = 24.0;
const ACTS: f64 = 30.0;
const FAULTS: f64 = 22.0;
const BUS: f64 = 30.0;
const NODE: f64 = 36.0;
/// Height of the box of a frame.
const BOX: f64 = 24.0;
const CURVES: f64 = 150.0;

/// What a picture shows.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Beginning.
    pub from: Time,
    /// End.
    pub until: Time,
    /// The parts of the story above.
    pub acts: bool,
    /// The error counters below.
    pub curves: bool,
    /// What it is, for readers who cannot see it.
    pub label: &'static str,
}

/// Draws a picture.
#[must_use]
pub fn draw(story: &Story, view: &View) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = Picture { story, view, attempts: story.attempts() }.draw(&mut out);
    out
}

struct Picture<'a> {
    story: &'a Story,
    view: &'a View,
    attempts: Vec<Attempt>,
}

impl Picture<'_> {
    fn draw(&self, out: &mut String) -> std::fmt::Result {
        let faults = self.faults().next().is_some();
        let acts_at = AXIS;
        let faults_at = acts_at + if self.view.acts { ACTS } else { 0.0 };
        let bus_at = faults_at + if faults { FAULTS } else { 0.0 } + 6.0;
        let nodes_at = bus_at + BUS;
        let curves_at = nodes_at + NODE * self.story.nodes.len() as f64 + 8.0;
        let height = curves_at + if self.view.curves { CURVES + 16.0 } else { 0.0 };
        writeln!(
            out,
            "<svg class=\"bus\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"{}\">",
            self.view.label
        )?;
        self.axis(out, height)?;
        if self.view.acts {
            self.acts(out, acts_at, height)?;
        }
        self.fault_row(out, faults_at)?;
        self.bus(out, bus_at)?;
        for node in 0..self.story.nodes.len() {
            self.node(out, node, nodes_at + NODE * node as f64)?;
        }
        if self.view.curves {
            self.curves(out, curves_at)?;
        }
        self.restarts(out, faults_at, height)?;
        writeln!(out, "</svg>")
    }

    fn x(&self, time: Time) -> f64 {
        let time = time.clamp(self.view.from, self.view.until);
        let span = self.view.until.since(self.view.from).as_ps().max(1) as f64;
        LEFT + time.since(self.view.from).as_ps() as f64 / span * (WIDTH - LEFT - RIGHT)
    }

    fn shows(&self, from: Time, until: Time) -> bool {
        from < self.view.until && until > self.view.from
    }

    /// Ticks at round times, about ten of them.
    fn axis(&self, out: &mut String, height: f64) -> std::fmt::Result {
        let span = self.view.until.since(self.view.from).as_ns();
        let steps = [20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000, 2_000_000];
        let step = steps.into_iter().find(|step| span / step <= 12).unwrap_or(5_000_000);
        let mut at = self.view.from.as_ns().div_ceil(step) * step;
        while at <= self.view.until.as_ns() {
            let x = self.x(Time::from_ns(at));
            let digits = if step < 100_000 { 2 } else { 1 };
            let text = at as f64 / 1e6;
            writeln!(
                out,
                "<path class=\"grid\" d=\"M{x:.1} {AXIS}V{height:.0}\"/>\
                 <text class=\"tick\" x=\"{x:.1}\" y=\"14\">{text:.digits$}</text>"
            )?;
            at += step;
        }
        writeln!(out, "<text class=\"unit\" x=\"{:.0}\" y=\"14\">ms</text>", LEFT - 12.0)
    }

    fn acts(&self, out: &mut String, top: f64, height: f64) -> std::fmt::Result {
        for (index, act) in self.story.acts.iter().enumerate() {
            let (from, until) = (self.x(act.from), self.x(act.until));
            let number = index + 1;
            let text = format!("{number}  {}", act.title);
            let text = if text.len() as f64 * 6.6 < until - from { text } else { number.to_string() };
            writeln!(
                out,
                "<a href=\"#act-{number}\"><title>{number}. {}</title>\
                 <rect class=\"act\" x=\"{:.1}\" y=\"{top}\" width=\"{:.1}\" height=\"22\" rx=\"4\"/>\
                 <text class=\"act-name\" x=\"{:.1}\" y=\"{:.1}\">{text}</text></a>\
                 <path class=\"act-edge\" d=\"M{from:.1} {top}V{height:.0}\"/>",
                act.title,
                from + 1.0,
                until - from - 2.0,
                (from + until) / 2.0,
                top + 15.5
            )?;
        }
        Ok(())
    }

    fn faults(&self) -> impl Iterator<Item = (&crate::story::Injected, Time)> {
        let end = self.story.end;
        let faults = self.story.faults.iter().map(move |fault| (fault, fault.until.unwrap_or(end)));
        faults.filter(|(fault, until)| self.shows(fault.time, *until))
    }

    /// How long a fault waits for its bits, and the bits that it has hit.
    fn fault_row(&self, out: &mut String, top: f64) -> std::fmt::Result {
        for (index, (fault, until)) in self.faults().enumerate() {
            if index == 0 {
                writeln!(out, "<text class=\"row\" x=\"8\" y=\"{:.1}\">fault</text>", top + 13.0)?;
            }
            let hits = self.story.hits(fault);
            let lasts = fault.frames > 1;
            let (from, to) = match hits.first() {
                Some(hit) if !lasts => (self.x(hit.start), self.x(hit.start + (hit.sample.since(hit.start)))),
                _ => (self.x(fault.time), self.x(until)),
            };
            let whose = if lasts { "of every frame" } else { "of one frame" };
            let name = self.story.nodes[fault.node].name;
            let text = format!("{} {whose} of {name} inverted", place(fault.position));
            let room = if lasts { to - from } else { WIDTH };
            let alone = lasts || self.view.until.since(self.view.from) < Time::from_ms(2);
            let shown = if alone && text.len() as f64 * 6.0 < room { text.as_str() } else { "" };
            writeln!(
                out,
                "<g><title>{text}: {} to {}</title><rect class=\"fault-on\" x=\"{from:.1}\" y=\"{:.1}\" \
                 width=\"{:.1}\" height=\"15\" rx=\"3\"/>",
                milliseconds(fault.time),
                milliseconds(until),
                top + 2.0,
                (to - from).max(2.0),
            )?;
            for hit in hits.iter().filter(|hit| self.shows(hit.start, hit.sample)) {
                let x = self.x(hit.start);
                write!(out, "<path class=\"hit\" d=\"M{:.1} {:.1}h5l-2.5 5z\"/>", x - 2.5, top + 15.0)?;
            }
            let at = if lasts { from + 6.0 } else { to + 6.0 };
            writeln!(out, "<text class=\"fault-name\" x=\"{at:.1}\" y=\"{:.1}\">{shown}</text></g>", top + 12.5)?;
        }
        Ok(())
    }

    /// Dominant times of the bus as filled blocks.
    fn bus(&self, out: &mut String, top: f64) -> std::fmt::Result {
        let (high, low) = (top + 2.0, top + 20.0);
        let mut path = String::new();
        let mut fell = None;
        for (time, signal, level) in self.story.recording.levels() {
            if *signal != Signal::Bus {
                continue;
            }
            if *level == Level::Dominant {
                fell = Some(*time);
            } else if let Some(from) = fell.take()
                && self.shows(from, *time)
            {
                let (x0, x1) = (self.x(from), self.x(*time));
                write!(path, "M{x0:.1} {high}H{x1:.1}V{low}H{x0:.1}z")?;
            }
        }
        writeln!(
            out,
            "<text class=\"row\" x=\"8\" y=\"{:.1}\">bus</text><path class=\"idle\" d=\"M{LEFT} {low}H{:.0}\"/>\
             <path class=\"dominant\" d=\"{path}\"><title>dominant</title></path>",
            top + 15.0,
            WIDTH - RIGHT
        )
    }

    fn node(&self, out: &mut String, node: usize, top: f64) -> std::fmt::Result {
        let name = self.story.nodes[node].name;
        let line = top + BOX + 2.0;
        writeln!(
            out,
            "<text class=\"row n{node}\" x=\"8\" y=\"{:.1}\">{name}</text><path class=\"idle\" d=\"M{LEFT} {line}H{:.0}\"/>",
            top + 18.0,
            WIDTH - RIGHT
        )?;
        for span in self.story.spans(node).iter().filter(|span| self.shows(span.from, span.until)) {
            self.span(out, node, span, top + 2.0)?;
        }
        self.losses(out, node, top + 2.0)
    }

    fn span(&self, out: &mut String, node: usize, span: &Span, top: f64) -> std::fmt::Result {
        let attempt = self.attempt_at(node, span);
        let sender = attempt.map_or(node, |attempt| attempt.node);
        let id = attempt.map_or_else(String::new, |attempt| format!("{:03X}", attempt.id));
        let name = self.story.nodes[sender].name;
        let fate = attempt.map_or_else(String::new, |attempt| match attempt.fate {
            Fate::Sent(_) => String::new(),
            Fate::Lost(at) => format!(", arbitration lost at {}", place(at)),
            Fate::Failed(error) => format!(", ended by an error at {}", place(error.position)),
        });
        let (class, text, says) = match span.doing {
            Doing::Rests | Doing::Off => return Ok(()),
            Doing::Sends => (format!("sends f{sender}"), id.clone(), format!("sends {id}{fate}")),
            Doing::Receives => (format!("receives f{sender}"), String::new(), format!("receives {id} of {name}")),
            Doing::ActiveFlag => (String::from("flag"), String::new(), String::from("active error flag")),
            Doing::PassiveFlag => (String::from("flag passive"), String::new(), String::from("passive error flag")),
            Doing::Delimiter => (String::from("delimiter"), String::new(), String::from("error delimiter")),
            Doing::Suspends => (String::from("suspends"), String::new(), String::from("suspend transmission")),
            Doing::Integrates => (String::from("integrates"), String::new(), String::from("bus integration")),
            Doing::BusOff => return self.bus_off(out, node, span, top),
        };
        let (x0, x1) = (self.x(span.from), self.x(span.until));
        let says = format!(
            "{}: {says}, {} to {}",
            self.story.nodes[node].name,
            milliseconds(span.from),
            milliseconds(span.until)
        );
        write!(
            out,
            "<g><title>{says}</title><rect class=\"{class}\" x=\"{x0:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{BOX}\"/>",
            (x1 - x0).max(0.8)
        )?;
        if let Some((from, until)) = span.fast {
            let (f0, f1) = (self.x(from), self.x(until));
            write!(out, "<rect class=\"fast\" x=\"{f0:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"4\"/>", f1 - f0)?;
        }
        if !text.is_empty() && text.len() as f64 * 7.4 < x1 - x0 {
            let (x, y) = ((x0 + x1) / 2.0, top + 16.5);
            write!(out, "<text class=\"id\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>")?;
        }
        writeln!(out, "</g>")
    }

    /// Where a node has lost arbitration.
    fn losses(&self, out: &mut String, node: usize, top: f64) -> std::fmt::Result {
        let close = self.view.until.since(self.view.from) < Time::from_ms(2);
        for attempt in self.attempts.iter().filter(|attempt| attempt.node == node) {
            let Fate::Lost(position) = attempt.fate else { continue };
            if !self.shows(attempt.until, attempt.until + Time::from_ps(1)) {
                continue;
            }
            let (x, y) = (self.x(attempt.until), top + BOX / 2.0);
            let (says, id) = (place(position), attempt.id);
            let shown = if close { format!("{id:03X} loses") } else { String::new() };
            writeln!(
                out,
                "<g><title>{id:03X} loses arbitration at {says}</title><path class=\"lost\" d=\"M{x:.1} {:.1}l7 6 -7 6z\"/>\
                 <text class=\"lost-name\" x=\"{:.1}\" y=\"{:.1}\">{shown}</text></g>",
                y - 6.0,
                x + 11.0,
                y + 4.0
            )?;
        }
        Ok(())
    }

    /// The attempt that a span belongs to: the node's own where it sends, else the one that fills the bus meanwhile.
    fn attempt_at(&self, node: usize, span: &Span) -> Option<&Attempt> {
        let own = span.doing == Doing::Sends;
        let overlap = |attempt: &&Attempt| attempt.until.min(span.until).since(attempt.from.max(span.from)).as_ps();
        let candidates = self.attempts.iter().filter(|attempt| match attempt.fate {
            _ if own => attempt.node == node,
            Fate::Lost(_) => false,
            _ => attempt.node != node,
        });
        candidates.max_by_key(overlap).filter(|attempt| overlap(attempt) > 0)
    }

    /// Silent until the driver restarts it, then on its way back.
    fn bus_off(&self, out: &mut String, node: usize, span: &Span, top: f64) -> std::fmt::Result {
        let restart = self.story.steps.iter().find(|step| {
            step.node == node && matches!(step.deed, Deed::Restarted) && (span.from..span.until).contains(&step.time)
        });
        let middle = restart.map_or(span.until, |step| step.time);
        let sequences = self.story.events(node).filter_map(|event| match event.kind {
            EventKind::RecoverySequence { count } if event.time <= span.until => Some(count),
            _ => None,
        });
        let recovers = format!("waits for {} × 11 recessive bits", sequences.last().unwrap_or_default());
        for (from, until, class, text) in
            [(span.from, middle, "off", "bus off"), (middle, span.until, "off recovers", recovers.as_str())]
        {
            let (x0, x1) = (self.x(from), self.x(until));
            if x1 - x0 < 0.1 {
                continue;
            }
            let shown = if text.len() as f64 * 6.2 < x1 - x0 { text } else { "" };
            writeln!(
                out,
                "<g><title>{text}: {} to {}</title><rect class=\"{class}\" x=\"{x0:.1}\" y=\"{top:.1}\" width=\"{:.1}\" \
                 height=\"{BOX}\"/><text class=\"off-name\" x=\"{:.1}\" y=\"{:.1}\">{shown}</text></g>",
                milliseconds(from),
                milliseconds(until),
                x1 - x0,
                (x0 + x1) / 2.0,
                top + 16.0
            )?;
        }
        Ok(())
    }

    /// A vertical line where the driver restarts its controller.
    fn restarts(&self, out: &mut String, top: f64, height: f64) -> std::fmt::Result {
        for step in &self.story.steps {
            if matches!(step.deed, Deed::Restarted) && self.shows(step.time, step.time + Time::from_ps(1)) {
                let x = self.x(step.time);
                writeln!(
                    out,
                    "<path class=\"restart\" d=\"M{x:.1} {top}V{height:.0}\"/>\
                     <text class=\"restart-name\" x=\"{:.1}\" y=\"{:.1}\">driver restarts {}</text>",
                    x + 5.0,
                    top + 13.0,
                    self.story.nodes[step.node].name
                )?;
            }
        }
        Ok(())
    }

    /// Error counters of all nodes, with the limits, over the error state of the disturbed node.
    fn curves(&self, out: &mut String, top: f64) -> std::fmt::Result {
        let bottom = top + CURVES;
        let y = |value: u16| bottom - f64::from(value.min(BUS_OFF)) / f64::from(BUS_OFF) * (CURVES - 12.0);
        let states = self.story.states(MOTOR);
        let ends = states.iter().skip(1).map(|(time, _)| *time).chain([self.story.end]);
        for ((from, state), until) in states.iter().zip(ends) {
            if !self.shows(*from, until) {
                continue;
            }
            let class = match state {
                can_wire::ErrorState::Active => "state-active",
                can_wire::ErrorState::Passive => "state-passive",
                can_wire::ErrorState::BusOff => "state-off",
            };
            let (x0, x1) = (self.x(*from), self.x(until));
            let text = state.to_string();
            let shown = if text.len() as f64 * 6.4 < x1 - x0 { text.as_str() } else { "" };
            writeln!(
                out,
                "<rect class=\"{class}\" x=\"{x0:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{CURVES}\"/>\
                 <text class=\"state-name\" x=\"{:.1}\" y=\"{:.1}\">{shown}</text>",
                x1 - x0,
                x0 + 6.0,
                top + 28.0
            )?;
        }
        writeln!(out, "<path class=\"idle\" d=\"M{LEFT} {bottom}H{:.0}\"/>", WIDTH - RIGHT)?;
        for (limit, name) in [(WARNING, "warning"), (PASSIVE, "passive"), (BUS_OFF, "bus off")] {
            let at = y(limit);
            writeln!(
                out,
                "<path class=\"limit\" d=\"M{LEFT} {at:.1}H{:.0}\"/><text class=\"limit-name\" x=\"{:.0}\" y=\"{:.1}\">{limit}</text>\
                 <text class=\"limit-word\" x=\"8\" y=\"{:.1}\">{name}</text>",
                WIDTH - RIGHT,
                LEFT - 6.0,
                at + 4.0,
                at + 4.0
            )?;
        }
        self.recovery(out, &y)?;
        for node in (0..self.story.nodes.len()).rev() {
            let counts = self.story.counts(node);
            self.curve(out, &format!("tec c{node}"), counts.iter().map(|count| (count.time, count.tec)), &y)?;
            self.curve(out, &format!("rec c{node}"), counts.iter().map(|count| (count.time, count.rec)), &y)?;
        }
        Ok(())
    }

    fn curve(
        &self,
        out: &mut String,
        class: &str,
        values: impl Iterator<Item = (Time, u16)>,
        y: &dyn Fn(u16) -> f64,
    ) -> std::fmt::Result {
        let (mut before, mut path) = (0, String::new());
        let mut rises = false;
        for (time, value) in values {
            if time >= self.view.until {
                break;
            }
            if time <= self.view.from {
                before = value;
                continue;
            }
            if value == before {
                continue;
            }
            let x = self.x(time);
            write!(path, "L{x:.1} {:.1}L{x:.1} {:.1}", y(before), y(value))?;
            before = value;
            rises = true;
        }
        if !rises && before == 0 {
            return Ok(());
        }
        let first = path.split_once(' ').map_or(y(before), |(_, rest)| {
            rest.split('L').next().and_then(|value| value.parse().ok()).unwrap_or(y(before))
        });
        writeln!(
            out,
            "<path class=\"curve {class}\" d=\"M{LEFT} {first:.1}{path}L{:.1} {:.1}\"/>",
            WIDTH - RIGHT,
            y(before)
        )
    }

    /// How many sequences of 11 recessive bits a recovering node has seen.
    fn recovery(&self, out: &mut String, y: &dyn Fn(u16) -> f64) -> std::fmt::Result {
        let counts = self.story.events(MOTOR).filter_map(|event| match event.kind {
            EventKind::RecoverySequence { count } => Some((event.time, count)),
            _ => None,
        });
        let mut path = String::new();
        for (time, count) in counts.filter(|(time, _)| self.shows(*time, *time + Time::from_ps(1))) {
            write!(path, "{}{:.1} {:.1}", if path.is_empty() { "M" } else { "L" }, self.x(time), y(count))?;
        }
        if path.is_empty() {
            return Ok(());
        }
        writeln!(out, "<path class=\"curve recovery c{MOTOR}\" d=\"{path}\"/>")
    }
}
