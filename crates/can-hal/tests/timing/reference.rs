//! Against the bit-timing calculation of the Linux kernel (from can-utils) and of python-can, with the limits of our
//! controllers. `data/regenerate.py` makes the tables.

use std::cmp::Ordering;

use can_hal::timing::{
    BitTiming, DataPhase, Limits, PhaseReport, PhaseRequest, Request, SamplePoint, Segments, Solution, Tolerance,
};

/// A bit of somebody else.
#[derive(Clone, Copy)]
struct Theirs {
    brp: u64,
    tseg1: u64,
    tseg2: u64,
    sjw: u64,
}

impl Theirs {
    fn segments(&self, propagation: u64) -> Segments {
        let [prescaler, propagation, phase1, phase2, jump_width] =
            [self.brp, propagation, self.tseg1 - propagation, self.tseg2, self.sjw].map(|value| value as u32);
        Segments { prescaler, propagation, phase1, phase2, jump_width }
    }
}

/// Deviation of bit rate and sample point, as fractions to compare exactly.
#[derive(Clone, Copy)]
struct Quality {
    rate: (u128, u128),
    point: (u128, u128),
}

impl Quality {
    fn of(clock: u64, request: &PhaseRequest, brp: u64, tseg1: u64, tseg2: u64) -> Self {
        let quanta = 1 + tseg1 + tseg2;
        let periods = brp * quanta;
        let target = u64::from(request.target().get());
        Self {
            rate: (clock.abs_diff(periods * u64::from(request.bit_rate)).into(), periods.into()),
            point: (((1 + tseg1) * 10_000).abs_diff(target * quanta).into(), quanta.into()),
        }
    }

    fn of_segments(clock: u64, request: &PhaseRequest, s: &Segments) -> Self {
        let before = u64::from(s.propagation + s.phase1);
        Self::of(clock, request, s.prescaler.into(), before, s.phase2.into())
    }

    fn compare(&self, other: &Self) -> Ordering {
        let fraction = |a: (u128, u128), b: (u128, u128)| (a.0 * b.1).cmp(&(b.0 * a.1));
        fraction(self.rate, other.rate).then(fraction(self.point, other.point))
    }
}

#[derive(Debug, Default, PartialEq, Eq)]
struct Score {
    equal: u32,
    better: u32,
    only_ours: u32,
    neither: u32,
    /// Theirs breaks a rule of the manual that they do not know.
    illegal: u32,
}

fn table(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map(|row| row.expect("a row").iter().map(str::to_owned).collect()).collect()
}

fn number(text: &str) -> u64 {
    text.parse().unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

fn theirs(row: &[String]) -> Option<Theirs> {
    if row[0].is_empty() {
        return None;
    }
    Some(Theirs { brp: number(&row[0]), tseg1: number(&row[1]), tseg2: number(&row[2]), sjw: number(&row[3]) })
}

/// Linux takes a bit rate that is off by 5 %, and any sample point.
fn linux_request(clock: u64, rate: u64, point: u64) -> Request {
    Request::new(clock as u32, rate as u32)
        .sample_point(SamplePoint::permille(point as u16))
        .within_ppm(50_000)
        .any_sample_point()
}

#[test]
fn linux() {
    let mut scores = Vec::new();
    for limits in Limits::ALL {
        for phase in ["nominal", "data"] {
            let mut score = Score::default();
            for row in table(include_str!("../data/linux.csv"))
                .iter()
                .filter(|row| row[0] == limits.controller && row[1] == phase)
            {
                let (clock, rate, point) = (number(&row[2]), number(&row[3]), number(&row[4]));
                let request = linux_request(clock, rate, point);
                // A data phase on its own: as the nominal phase of a controller that has the data phase's limits.
                let limits = if phase == "data" {
                    Limits {
                        nominal: limits.data.expect("the table has a data phase"),
                        data: None,
                        delay: None,
                        ..limits
                    }
                } else {
                    limits
                };
                let what = format!("{} {phase} {clock} {rate}", limits.controller);
                let clock = clock / u64::from(limits.divider);
                let ours = limits.solve(&request);
                match (&ours, theirs(&row[5..])) {
                    (Ok(_), None) => score.only_ours += 1,
                    (Err(_), None) => score.neither += 1,
                    (ours, Some(theirs)) => {
                        let quality = Quality::of(clock, &request.nominal, theirs.brp, theirs.tseg1, theirs.tseg2);
                        // Their split of the time before the sample point is not ours; what counts is that there is one.
                        let legal = (0..theirs.tseg1).any(|propagation| {
                            let nominal = theirs.segments(propagation);
                            limits.check(&BitTiming { nominal, data: None, three_samples: false }).is_ok()
                        });
                        if !legal {
                            score.illegal += 1;
                            continue;
                        }
                        let ours = ours.as_ref().unwrap_or_else(|error| panic!("{what}: {error}"));
                        match Quality::of_segments(clock, &request.nominal, &ours.timing.nominal).compare(&quality) {
                            Ordering::Less => score.better += 1,
                            Ordering::Equal => score.equal += 1,
                            Ordering::Greater => panic!("{what}: Linux is better: {:?}", ours.timing.nominal),
                        }
                    }
                }
            }
            if score != Score::default() {
                scores.push((limits.controller, phase, score));
            }
        }
    }
    let score = |equal, better, neither, illegal| Score { equal, better, only_ours: 0, neither, illegal };
    let expected = [
        ("m_can", "nominal", score(72, 0, 0, 0)),
        ("m_can", "data", score(37, 1, 2, 0)),
        ("dspic33_canfd", "nominal", score(54, 0, 0, 0)),
        ("dspic33_canfd", "data", score(25, 3, 2, 0)),
        ("dspic33_ecan", "nominal", score(61, 0, 10, 1)),
        ("pic32_can", "nominal", score(61, 0, 10, 1)),
    ];
    assert_eq!(scores, expected);
    let rows: u32 = scores.iter().map(|(_, _, s)| s.equal + s.better + s.only_ours + s.neither + s.illegal).sum();
    assert_eq!(rows as usize, table(include_str!("../data/linux.csv")).len(), "every row counts once");
}

/// Sample points and rates as `Solution` states them, against the tables' own arithmetic.
fn check_report(clock: u64, request: &PhaseRequest, segments: &Segments, report: &PhaseReport) {
    let quanta = f64::from(segments.quanta());
    let rate = clock as f64 / (f64::from(segments.prescaler) * quanta);
    let error = (rate / f64::from(request.bit_rate) - 1.0) * 1e6;
    assert!((f64::from(report.error_ppm) - error).abs() <= 1.0 + 1e-6, "{report:?} {error}");
    assert_eq!(report.error_ppm == 0, error.abs() < 1e-9);
    let point = f64::from(segments.before_sample()) / quanta * 10_000.0;
    assert!((f64::from(report.sample_point.get()) - point).abs() <= 0.5);
}

#[test]
fn python_can() {
    // Its limits are those of the CAN FD module, its clock is not limited.
    let limits = Limits { max_clock: None, ..Limits::DSPIC33_CANFD };
    let mut score = Score::default();
    let rows = table(include_str!("../data/python_can.csv"));
    for row in &rows {
        let [clock, rate, point, data_rate, data_point] = [0, 1, 2, 3, 4].map(|i| number(&row[i]));
        let request = Request::new(clock as u32, rate as u32)
            .sample_point(SamplePoint::permille(point as u16))
            .data(data_rate as u32)
            .data_sample_point(SamplePoint::permille(data_point as u16))
            // It takes a bit rate that is off by 1/256.
            .within_ppm(3_907)
            .any_sample_point();
        let what = format!("{clock} {rate} {data_rate}");
        let ours = limits.solve(&request);
        let Some(nominal) = theirs(&row[5..]) else {
            if ours.is_ok() {
                score.only_ours += 1
            } else {
                score.neither += 1
            }
            continue;
        };
        let data = theirs(&row[9..]).expect("both phases or none");
        let Solution { timing, nominal: report, data: data_report, .. } =
            ours.unwrap_or_else(|error| panic!("{what}: {error}"));
        let data_request = request.data.expect("asked for");
        let data_segments = timing.data.expect("asked for").segments;
        check_report(clock, &request.nominal, &timing.nominal, &report);
        check_report(clock, &data_request, &data_segments, &data_report.expect("asked for"));
        let phases = [(&request.nominal, &timing.nominal, nominal), (&data_request, &data_segments, data)];
        let mut best = Ordering::Equal;
        for (request, segments, theirs) in phases {
            let quality = Quality::of(clock, request, theirs.brp, theirs.tseg1, theirs.tseg2);
            let order = Quality::of_segments(clock, request, segments).compare(&quality);
            assert_ne!(order, Ordering::Greater, "{what}: python-can is better: {segments:?}");
            best = best.min(order);
        }
        if best == Ordering::Less {
            score.better += 1
        } else {
            score.equal += 1
        }

        // The tolerance of their timing, all of the time before the sample point being phase segment 1.
        let segments = data.segments(0);
        let timing = BitTiming {
            nominal: nominal.segments(0),
            data: Some(DataPhase { segments, compensation: None }),
            three_samples: false,
        };
        let expected = number(&row[13]);
        assert!(
            u64::from(Tolerance::of(&timing).min()).abs_diff(expected) <= 1,
            "{what}: {:?}",
            Tolerance::of(&timing)
        );
    }
    assert_eq!(score, Score { equal: 233, better: 82, only_ours: 9, neither: 36, illegal: 0 });
    assert_eq!((score.equal + score.better + score.only_ours + score.neither) as usize, rows.len());
}
