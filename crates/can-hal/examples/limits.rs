//! Prints the limits of every controller and phase as CSV, for other programs to calculate with.

use can_hal::timing::Limits;

fn main() {
    println!("controller,phase,divider,max_clock,tseg1_min,tseg1_max,tseg2_min,tseg2_max,sjw_max,brp_min,brp_max");
    for limits in Limits::ALL {
        let phases = [("nominal", Some(limits.nominal)), ("data", limits.data)];
        for (name, phase) in phases.into_iter().filter_map(|(name, phase)| Some((name, phase?))) {
            let (least, most) = phase.propagation.map_or((0, 0), |range| (range.min, range.max));
            println!(
                "{},{name},{},{},{},{},{},{},{},{},{}",
                limits.controller,
                limits.divider,
                limits.max_clock.unwrap_or(u32::MAX),
                phase.phase1.min + least,
                phase.phase1.max + most,
                phase.phase2.min,
                phase.phase2.max,
                phase.jump_width.max,
                phase.prescaler.min,
                phase.prescaler.max
            );
        }
    }
}
