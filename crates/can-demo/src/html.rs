//! The report: one HTML file that needs nothing else.

use can_hal::{ErrorState, LastError, Status, timing::Segments};
use can_sim::AccessRecord;
use can_wire::{
    NodeId, Time,
    output::{FrameCapture, Picture},
};
use minijinja::{Environment, UndefinedBehavior, Value, context, syntax::SyntaxConfig};
use regbus::meta;

use crate::{
    Error, Story, files,
    moments::{self, Kind, bit_rate, milliseconds, moments, place},
    picture::{View, draw},
    play::{LOGGER, MOTOR, PANEL, VICTIM},
    story::{Attempt, Deed, Fate, Step},
};

/// The whole page.
///
/// # Errors
/// [`Error::Template`] if the template asks for something that it does not get.
pub fn report(story: &Story) -> Result<String, Error> {
    let mut templates = Environment::new();
    templates.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build().map_err(Error::Template)?;
    templates.set_syntax(syntax);
    templates.add_template("report.html", include_str!("../templates/report.html")).map_err(Error::Template)?;
    let page = templates.get_template("report.html").map_err(Error::Template)?;
    let entries: Vec<Value> = story.steps.iter().map(|step| entry(story, step)).collect();
    let accesses: usize = story.steps.iter().map(|step| step.records.len()).sum();
    let safe = |text: String| Value::from_safe_string(text);
    let context = context! {
        css => safe(include_str!("../templates/report.css").to_owned()),
        js => safe(include_str!("../templates/report.js").to_owned()),
        nodes => nodes(story),
        rate => bit_rate(story.rate),
        data_rate => story.data_rate.map(bit_rate),
        end => milliseconds(story.end),
        overview => safe(overview(story)),
        acts => acts(story),
        facts => facts(story),
        steps => entries.len(),
        entries,
        accesses,
        diagnostics => &story.diagnostics,
        files => context! { vcd => files::VCD, pcapng => files::PCAPNG, candump => files::CANDUMP },
    };
    page.render(context).map_err(Error::Template)
}

fn nodes(story: &Story) -> Vec<Value> {
    let nodes = story.nodes.iter().enumerate();
    nodes
        .map(|(index, node)| {
            let clock = format!("{} MHz", f64::from(node.clock) / 1e6);
            let ppm = format!("{:+} ppm", node.ppm);
            let nominal = node.timing.map(|timing| segments(&timing.nominal));
            let data = node.timing.and_then(|timing| timing.data).map(|data| segments(&data.segments));
            context! { index, name => node.name, title => node.title, clock, ppm, nominal, data }
        })
        .collect()
}

fn segments(segments: &Segments) -> String {
    format!("{} time quanta, sample point {}", segments.quanta(), segments.sample_point())
}

fn overview(story: &Story) -> String {
    let label = "All of the story: what each node does on the bus, and its error counters";
    draw(story, &View { from: Time::ZERO, until: story.end, acts: true, curves: true, label })
}

fn acts(story: &Story) -> Vec<Value> {
    let all = moments(story);
    let acts = story.acts.iter().enumerate();
    acts.map(|(index, act)| {
        let lines: Vec<Value> =
            all.iter().filter(|moment| story.act_at(moment.time) == index).map(|moment| line(story, moment)).collect();
        // Not worth their room where they stay near the ground.
        let highest = |time| story.count_at(MOTOR, time).tec >= moments::WARNING;
        let curves = highest(act.from) && highest(act.until) || highest(Time::from_ps(act.until.as_ps() - 1));
        let view = View { from: act.from, until: act.until, acts: false, curves, label: act.title };
        context! {
            number => index + 1,
            title => act.title,
            from => milliseconds(act.from),
            until => milliseconds(act.until),
            picture => Value::from_safe_string(draw(story, &view)),
            lines,
        }
    })
    .collect()
}

fn line(story: &Story, moment: &moments::Moment) -> Value {
    let (kind, mark) = match (moment.kind, moment.state) {
        (Kind::Sent, _) => ("sent", "▶"),
        (Kind::Lost, _) => ("lost", "◁"),
        (Kind::Failed, _) => ("failed", "✗"),
        (Kind::Fault, _) => ("fault", "↯"),
        (Kind::State, Some(can_wire::ErrorState::Active)) => ("good", "●"),
        (Kind::State, Some(can_wire::ErrorState::BusOff)) => ("bad", "●"),
        (Kind::State, _) => ("warn", "●"),
        (Kind::Driver, _) => ("driver", "↻"),
    };
    context! {
        time => milliseconds(moment.time),
        node => moment.node,
        name => story.nodes[moment.node].name,
        kind,
        mark,
        text => moment.text.clone(),
        tec => moment.tec,
    }
}

/// The numbers that the text of the page speaks of.
fn facts(story: &Story) -> Value {
    let attempts = story.attempts();
    let lost = attempts.iter().find(|attempt| matches!(attempt.fate, Fate::Lost(_)));
    let failures: Vec<&Attempt> = attempts.iter().filter(|attempt| matches!(attempt.fate, Fate::Failed(_))).collect();
    let winner = lost.and_then(|lost| {
        attempts.iter().find(|other| other.node != lost.node && other.from < lost.until && other.until > lost.until)
    });
    let first = failures.first().copied();
    let second = attempts.iter().find(|attempt| first.is_some_and(|first| attempt.from > first.until));
    let fault = story.faults.iter().find(|fault| fault.frames > 1);
    let persistent = failures.iter().filter(|failure| fault.is_some_and(|fault| failure.from >= fault.time));
    let persistent: Vec<&&Attempt> = persistent.collect();
    let state = |wanted| story.states(MOTOR).iter().find(|(_, state)| *state == wanted).map(|(time, _)| *time);
    let passive = state(can_wire::ErrorState::Passive).unwrap_or_default();
    let off = state(can_wire::ErrorState::BusOff).unwrap_or_default();
    let back = story.bus_off(MOTOR).first().map(|(_, until)| *until).unwrap_or_default();
    let restart = story.steps.iter().find(|step| matches!(step.deed, Deed::Restarted)).map(|step| step.time);
    let restart = restart.unwrap_or_default();
    let meanwhile = attempts.iter().filter(|attempt| {
        attempt.node == PANEL && attempt.from > off && attempt.until < back && matches!(attempt.fate, Fate::Sent(_))
    });
    let between =
        attempts.iter().find(|attempt| attempt.node == PANEL && attempt.from > passive && attempt.until < off);
    let sequences = story.events(MOTOR).filter(|event| event.time <= back).filter_map(|event| match event.kind {
        can_wire::EventKind::RecoverySequence { count } => Some(count),
        _ => None,
    });
    let tec = |time: Time| story.count_at(MOTOR, time).tec;
    let most = |node: usize| story.counts(node).iter().map(|count| count.rec).max().unwrap_or(0);
    let last = |node: usize| story.count_at(node, story.end);
    context! {
        frames => attempts.iter().filter(|attempt| matches!(attempt.fate, Fate::Sent(_))).count(),
        failures => failures.len(),
        lost => lost.map(|lost| context! {
            time => milliseconds(lost.until),
            id => format!("{:03X}", lost.id),
            bits => binary(lost.id),
            place => match lost.fate { Fate::Lost(position) => place(position), _ => String::new() },
            name => story.nodes[lost.node].name,
            capture => Value::from_safe_string(capture(story, lost)),
        }),
        winner => winner.map(|winner| context! {
            id => format!("{:03X}", winner.id),
            bits => binary(winner.id),
            name => story.nodes[winner.node].name,
        }),
        victim => place(VICTIM),
        error => context! {
            tec => first.map(|first| tec(first.until)),
            after => second.map(|second| tec(second.until)),
            pause => second.zip(first).map(|(second, first)| microseconds(second.from.since(first.until))),
            capture => Value::from_safe_string(first.map_or_else(String::new, |first| capture(story, first))),
        },
        fault => context! {
            attempts => persistent.len(),
            until_passive => persistent.iter().filter(|failure| failure.until <= passive).count(),
            after_passive => persistent.iter().filter(|failure| failure.until > passive).count(),
            passive => milliseconds(passive),
            passive_tec => tec(passive),
            off => milliseconds(off),
            off_tec => tec(off),
            between => between.map(|attempt| context! { id => format!("{:03X}", attempt.id), time => milliseconds(attempt.from) }),
            panel_rec => most(PANEL),
            logger_rec => most(LOGGER),
        },
        recovery => context! {
            pause => milliseconds(story.pause),
            restart => milliseconds(restart),
            back => milliseconds(back),
            took => milliseconds(back.since(restart)),
            sequences => sequences.last(),
            meanwhile => meanwhile.count(),
            repaired => fault.and_then(|fault| fault.until).map(milliseconds),
        },
        counts => (0..story.nodes.len()).map(|node| context! {
            name => story.nodes[node].name, node, tec => last(node).tec, rec => last(node).rec
        }).collect::<Vec<_>>(),
    }
}

fn binary(id: u32) -> String {
    format!("{:03b} {:04b} {:04b}", id >> 8 & 7, id >> 4 & 15, id & 15)
}

fn microseconds(time: Time) -> String {
    format!("{} µs", (time.as_ns() + 500) / 1_000)
}

/// The bits of an attempt at all nodes.
fn capture(story: &Story, attempt: &Attempt) -> String {
    let reference: NodeId = story.nodes[attempt.node].id;
    let mut capture = FrameCapture::new(reference, 0);
    story.recording.replay(attempt.from, &mut capture);
    let names: Vec<&str> = story.nodes.iter().map(|node| node.name).collect();
    capture.draw(&Picture { names: &names, bare: true, bit: 15.0 })
}

fn entry(story: &Story, step: &Step) -> Value {
    let list = |frames: &[can_frame::Frame]| frames.iter().map(moments::frame).collect::<Vec<_>>().join("; ");
    let (kind, text) = match &step.deed {
        Deed::Configured => ("setup", String::from("configures the controller: bit timing, message memory, FIFOs")),
        Deed::Started => ("setup", String::from("goes on the bus and enables its interrupts")),
        Deed::Sent(frame) => ("send", format!("gives the controller a frame: {}", moments::frame(frame))),
        Deed::Served { received, sent, status, .. } => {
            let mut parts = Vec::new();
            if !received.is_empty() {
                parts.push(format!("received {}", list(received)));
            }
            if !sent.is_empty() {
                parts.push(format!("sent {}", list(sent)));
            }
            if let Some(status) = status {
                parts.push(seen(status));
            }
            if parts.is_empty() {
                parts.push(String::from("nothing new"));
            }
            (if status.is_some() { "error" } else { "interrupt" }, format!("interrupt: {}", parts.join("; ")))
        }
        Deed::Looked(status) => ("look", format!("looks at its state: {}", seen(status))),
        Deed::Restarted => ("restart", String::from("begins the recovery from bus off")),
        Deed::ReportsErrors(false) => ("setup", String::from("wants no interrupt for single errors while bus off")),
        Deed::ReportsErrors(true) => ("setup", String::from("wants an interrupt for single errors again")),
    };
    context! {
        act => story.act_at(step.time) + 1,
        time => milliseconds(step.time),
        node => step.node,
        name => story.nodes[step.node].name,
        text,
        kind,
        count => step.records.len(),
        accesses => step.records.chunk_by(is_same).map(access).collect::<Vec<_>>(),
    }
}

/// What a driver has read of its state.
fn seen(status: &Status) -> String {
    let state = match status.error_state {
        ErrorState::Active if status.warning => "error active, warning",
        ErrorState::Active => "error active",
        ErrorState::Passive => "error passive",
        ErrorState::BusOff => "bus off",
    };
    let error = match status.last_error.or(status.last_data_error) {
        None | Some(LastError::None) => "",
        Some(LastError::Stuff) => "stuff error, ",
        Some(LastError::Form) => "form error, ",
        Some(LastError::Ack) => "acknowledgement error, ",
        Some(LastError::Bit1 | LastError::Bit0) => "bit error, ",
        Some(LastError::Crc) => "CRC error, ",
    };
    format!("{error}{state}, TEC {}, REC {}", status.counters.transmit, status.counters.receive)
}

/// One poll after the other sees the same.
fn is_same(one: &AccessRecord, other: &AccessRecord) -> bool {
    !one.write && !other.write && (one.offset, one.width, one.value) == (other.offset, other.width, other.value)
}

/// Equal accesses in a row of the table.
fn access(records: &[AccessRecord]) -> Value {
    let [record, ..] = records else { return context! {} };
    let digits = usize::from(record.width.0) / 4;
    let (register, fields): (String, Vec<Value>) = match &record.register {
        Some(register) => {
            // A write is shown as it was written: what a register makes of it is another matter.
            let whole = record.write && record.width.0 == 32;
            let value = if whole { record.value } else { register.value };
            (register.name.clone(), register.fields.iter().flat_map(|field| decoded(field, value)).collect())
        }
        None => (String::from("no register"), Vec::new()),
    };
    context! {
        time => format!("{:.1}", record.time.as_ns() as f64 / 1_000.0),
        write => record.write,
        times => records.len(),
        register,
        offset => format!("{:#05x}", record.offset),
        value => format!("{:#0width$x}", record.value, width = digits + 2),
        fields,
    }
}

/// The lanes of a field that are not 0, with the names of their values.
fn decoded(field: &'static meta::Field, word: u32) -> impl Iterator<Item = Value> {
    (0..field.lanes).filter_map(move |lane| {
        let value = field.get(word, lane);
        if value == 0 {
            return None;
        }
        let name = if field.lanes > 1 {
            format!("{}[{}]", field.name, field.first_lane + lane)
        } else {
            field.name.to_owned()
        };
        let shown = match field.values.and_then(|values| values.name_of(value)) {
            Some(name) => name.to_owned(),
            None if field.width == 1 => String::from("1"),
            None if field.width > 8 => format!("{value:#x}"),
            None => value.to_string(),
        };
        Some(context! { name, value => shown })
    })
}
