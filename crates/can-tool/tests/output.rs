//! What the commands print.

use can_tool::{Cli, Output, run};
use clap::Parser;

fn parse(line: &str) -> Result<Output, String> {
    let words = std::iter::once("xtask").chain(line.split_whitespace());
    let cli = Cli::try_parse_from(words).map_err(|error| error.to_string())?;
    run(&cli)
}

fn text(line: &str) -> String {
    match parse(line) {
        Ok(output) => output.text,
        Err(error) => format!("error: {error}\n"),
    }
}

#[test]
fn bit_timing_m_can() {
    insta::assert_snapshot!(text("bit-timing --controller m_can --clock 40M --nominal 500k --data 2M"));
}

#[test]
fn bit_timing_canfd_example() {
    let line = "bit-timing --controller dspic33_canfd --clock 80M --nominal 500k --data 2M --sample-point 80% \
                --data-sample-point 80% --bus-length 40";
    insta::assert_snapshot!(text(line));
}

#[test]
fn bit_timing_ecan() {
    insta::assert_snapshot!(text("bit-timing --controller dspic33_ecan --clock 40M --nominal 125k"));
}

#[test]
fn bit_timing_pic32_three_samples() {
    let line = "bit-timing --controller pic32_can --clock 80M --nominal 1M --sample-point 70% --three-samples";
    insta::assert_snapshot!(text(line));
}

#[test]
fn bit_timing_svg() {
    let line = "bit-timing --controller m_can --clock 40M --nominal 500k --data 2M --svg bit.svg";
    let (path, content) = parse(line).expect("this is possible").file.expect("asked for");
    assert_eq!(path, std::path::Path::new("bit.svg"));
    insta::assert_snapshot!(content);
}

#[test]
fn bit_timing_errors() {
    let lines = [
        "bit-timing --controller m_can --clock 40M --nominal 300k",
        "bit-timing --controller m_can --clock 16M --nominal 1M --data 5M",
        "bit-timing --controller dspic33_canfd --clock 120M --nominal 500k",
        "bit-timing --controller pic32_can --clock 80M --nominal 500k --data 2M",
        "bit-timing --controller dspic33_ecan --clock 40M --nominal 12.5k",
        "bit-timing --controller m_can --clock 40X --nominal 500k",
        "bit-timing --controller m_can --clock 40M --nominal 500k --sample-point 101%",
        "bit-timing --controller m_can --clock 40M --nominal 500k --data-sample-point 75%",
        "bit-timing --controller other --clock 40M --nominal 500k",
    ];
    let shown: Vec<_> = lines.iter().map(|line| format!("$ {line}\n{}", text(line))).collect();
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn memory_m_can() {
    let line = "memory --controller m_can --ram 8Ki --standard-filters 28 --extended-filters 8 --rx-fifo-0 32x64 \
                --rx-fifo-1 4x64@0xc00 --rx-buffers 2x64 --tx-events 8 --tx-buffers 12+20x64";
    insta::assert_snapshot!(text(line));
}

#[test]
fn memory_canfd_table_10_1() {
    let line = "memory --controller dspic33_canfd --base 0x1400 --ram 2Ki --tef 12t --txq 8x32 --fifo 1:tx:5x64 \
                --fifo 2:rx:16x64t";
    insta::assert_snapshot!(text(line));
}

#[test]
fn memory_pic32_with_a_gap() {
    let line = "memory --controller pic32_can --base 0x1000 --ram 0x100 --fifo 0:tx:4 --fifo 1:data:2 --fifo 3:rx:4";
    insta::assert_snapshot!(text(line));
}

#[test]
fn memory_ecan() {
    insta::assert_snapshot!(text("memory --controller dspic33_ecan --ram 2Ki --buffers 12 --fifo-start 5"));
}

#[test]
fn memory_errors() {
    let lines = [
        "memory --controller m_can --ram 1Ki --rx-fifo-0 64x64",
        "memory --controller m_can --ram 8Ki --standard-filters 28 --rx-fifo-0 4x8@0x60",
        "memory --controller m_can --ram 8Ki --rx-fifo-0 4",
        "memory --controller m_can --ram 8Ki --rx-fifo-0 4x10",
        "memory --controller m_can --ram 8Ki --standard-filters 4x8",
        "memory --controller m_can --ram 8Ki --txq 4x8",
        "memory --controller dspic33_canfd --ram 2Ki --fifo 32:tx:1x8",
        "memory --controller dspic33_canfd --ram 2Ki --fifo 1:data:1x8",
        "memory --controller dspic33_canfd --ram 2Ki --fifo 1:up:1x8",
        "memory --controller dspic33_canfd --ram 2Ki --fifo 1tx8",
        "memory --controller dspic33_ecan --ram 2Ki --buffers 5",
        "memory --controller dspic33_ecan --ram 2Ki",
        "memory --controller m_can --ram lots",
    ];
    let shown: Vec<_> = lines.iter().map(|line| format!("$ {line}\n{}", text(line))).collect();
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn the_exit_code_tells_what_went_wrong() {
    let code = |line: &str| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_can-tool"));
        command.args(line.split_whitespace()).output().expect("the program runs").status.code()
    };
    assert_eq!(code("bit-timing --controller m_can --clock 40M --nominal 500k"), Some(0));
    assert_eq!(code("bit-timing --controller m_can --clock 40M --nominal 300k"), Some(1));
    assert_eq!(code("bit-timing --controller m_can --clock 40M"), Some(2));
    assert_eq!(code("bit-timing --controller m_can --clock 40M --nominal 500k --svg /no/such/folder/x.svg"), Some(2));
    assert_eq!(code("memory --controller m_can --ram 16 --standard-filters 4"), Some(0));
    assert_eq!(code("memory --controller m_can --ram 16 --standard-filters 5"), Some(1));
}
