//! What the functions of the C header do: the values they leave in memory, and how many accesses they are.

use std::process::Command;

use canpac_tests::{model, root};

fn header(feature: &str) -> String {
    let model = model(&root().join(format!("crates/regdef-codegen/tests/features/{feature}.yaml")));
    regdef_codegen::c::header(&model)
}

/// Compiles and runs a C program; its `check`s that fail come back as line numbers.
fn run(feature: &str, body: &str) {
    let dir = tempfile::tempdir().expect("a folder for the program");
    std::fs::write(dir.path().join("header.h"), header(feature)).expect("a writable folder");
    let source = format!(
        "#include <assert.h>\n#define {upper}_ASSERT(condition) assert(condition)\n#include \"header.h\"\n\
         #define CHECK(condition) do {{ if (!(condition)) {{ return __LINE__; }} }} while (0)\n\
         static {feature}_regs_t block;\nint main(void)\n{{\n{feature}_regs_t *regs = &block;\n(void)regs;\n#line 1\n\
         {body}\nreturn 0;\n}}\n",
        upper = feature.to_uppercase(),
    );
    std::fs::write(dir.path().join("main.c"), source).expect("a writable folder");
    let built = Command::new("gcc")
        .args(["-std=c11", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-o", "main", "main.c"])
        .current_dir(dir.path())
        .output()
        .expect("gcc runs; Debian package gcc");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let status = Command::new(dir.path().join("main")).status().expect("the program runs");
    assert!(status.success(), "{feature}: the check in line {:?} of the body fails", status.code());
}

#[test]
fn flags_requests_and_stored_fields() {
    run(
        "access",
        "regs->FLAGS = 0;
        access_flags_clear(regs, ACCESS_FLAGS_ONE_Msk);
        CHECK(regs->FLAGS == (ACCESS_FLAGS_ONE_Msk | ACCESS_FLAGS_ZERO_Msk));
        access_flags_clear(regs, ACCESS_FLAGS_ZERO_Msk);
        CHECK(regs->FLAGS == 0);
        access_flags_request(regs, ACCESS_FLAGS_GO_Msk);
        CHECK(regs->FLAGS == (ACCESS_FLAGS_GO_Msk | ACCESS_FLAGS_ZERO_Msk));
        regs->PLAIN = 0xFFFF0000;
        access_plain_modify(regs, ACCESS_PLAIN_MARK_Msk, ACCESS_PLAIN_NISO_Msk);
        CHECK(regs->PLAIN == 0xFFF08000);
        CHECK(access_plain_mark_set(0xFFFFFFFF, 5) == 0xFFF5FFFF);
        CHECK(access_plain_mark_get(0x00050000) == 5);
        CHECK(ACCESS_PLAIN_MARK_SET(0xFF) == ACCESS_PLAIN_MARK_Msk);
        regs->TIMER = 7;
        access_timer_restart(regs);
        CHECK(regs->TIMER == 0);",
    );
}

#[test]
fn aliases_and_elements() {
    run(
        "aliases",
        "aliases_con_set(regs, 0x10);
        CHECK(regs->CONSET == 0x10 && regs->CON == 0);
        aliases_con_clr(regs, 0x20);
        CHECK(regs->CONCLR == 0x20);
        aliases_con_inv(regs, 0x40);
        CHECK(regs->CONINV == 0x40);",
    );
    run("clusters", "CHECK(clusters_fifo_conl(regs, 1) == &regs->FIFO[0].FIFOCONL);");
    run(
        "arrays",
        "*arrays_rxf(regs, 3) = 9;
        CHECK((uintptr_t)arrays_rxf(regs, 3) - (uintptr_t)regs == 0x10);
        CHECK((uintptr_t)arrays_dma(regs, 1) - (uintptr_t)regs == 0x0C);",
    );
}

#[test]
fn joined_values_and_payload() {
    run(
        "joined",
        "joined_tbc_write(regs, 0x12345678);
        CHECK(regs->TBCL == 0x5678 && regs->TBCH == 0x1234);
        CHECK(joined_tbc_read(regs) == 0x12345678);
        joined_flags_clear(regs, 0x80000001);
        CHECK(regs->FLAG1 == 0xFFFE && regs->FLAG2 == 0x7FFF);
        joined_requests_request(regs, 0x00010002);
        CHECK(regs->REQL == 2 && regs->REQH == 1);
        regs->RXF[1].RXFSID = JOINED_RXF_SID_EXIDE_Msk;
        joined_rxf_id_write(regs, 1, 0x1FFFFFFF);
        CHECK(regs->RXF[1].RXFSID == 0xFFEB && regs->RXF[1].RXFEID == 0xFFFF);
        joined_rxf_id_write(regs, 1, 0x12345678);
        CHECK(joined_rxf_id_read(regs, 1) == 0x12345678);
        joined_tx_object_t object = {0};
        joined_tx_object_eid_write(&object, 0x2ABCD);
        CHECK(joined_tx_object_eid_read(&object) == 0x2ABCD);
        CHECK(JOINED_TX_OBJECT_BYTES(joined_tx_object_payload_bytes(1)) == 11);
        const uint8_t data[7] = {1, 2, 3, 4, 5, 6, 7};
        uint8_t back[7] = {0};
        joined_tx_object_write_payload(&object, data, 7);
        CHECK(object.PAYLOAD[0] == 0x0201 && object.PAYLOAD[3] == 0x0007);
        joined_tx_object_read_payload(&object, back, 7);
        for (int at = 0; at < 7; ++at) { CHECK(back[at] == data[at]); }",
    );
}

#[test]
fn the_window_is_selected_and_nothing_else_changes() {
    run(
        "windows",
        "regs->CTRL = 0;
        windows_select_filters_window(regs);
        CHECK(regs->CTRL == 1);
        windows_select_buffers_window(regs);
        CHECK(regs->CTRL == 0);
        CHECK((const volatile void *)&regs->WINDOW.BUFFERS.RXFUL == (const volatile void *)&regs->WINDOW.FILTERS.BUFPNT);",
    );
}

/// Loads and stores of a function on ARM, those of constants not counted.
fn accesses(feature: &str, call: &str) -> (usize, usize) {
    let dir = tempfile::tempdir().expect("a folder for the listing");
    std::fs::write(dir.path().join("header.h"), header(feature)).expect("a writable folder");
    let source = format!(
        "#include \"header.h\"\nvoid function({feature}_regs_t *regs);\nvoid function({feature}_regs_t *regs) {{ {call}; }}\n"
    );
    std::fs::write(dir.path().join("unit.c"), source).expect("a writable folder");
    let output = Command::new("arm-none-eabi-gcc")
        .args(["-std=c99", "-O2", "-mthumb", "-mcpu=cortex-m4", "-ffreestanding", "-S", "-o", "-", "unit.c"])
        .current_dir(dir.path())
        .output()
        .expect("arm-none-eabi-gcc runs; Debian package gcc-arm-none-eabi");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let listing = String::from_utf8_lossy(&output.stdout).into_owned();
    let count = |kind: &str| {
        let access = |line: &&str| line.trim_start().starts_with(kind) && line.contains('[');
        listing.lines().filter(access).count()
    };
    (count("ldr"), count("str"))
}

#[test]
fn one_store_is_one_store() {
    for (feature, call, loads, stores) in [
        ("access", "access_flags_clear(regs, ACCESS_FLAGS_ZERO_Msk)", 0, 1),
        ("access", "access_flags_request(regs, ACCESS_FLAGS_GO_Msk)", 0, 1),
        ("access", "access_timer_restart(regs)", 0, 1),
        ("access", "access_plain_modify(regs, 1, 2)", 1, 1),
        ("aliases", "aliases_con_set(regs, 1)", 0, 1),
        ("joined", "joined_flags_clear(regs, 1)", 0, 2),
        ("joined", "(void)joined_rxf_id_read(regs, 1)", 2, 0),
        ("windows", "windows_select_filters_window(regs)", 1, 1),
    ] {
        assert_eq!(accesses(feature, call), (loads, stores), "{call}");
    }
}

/// Whether a statement with the manufacturer's names compiles.
fn compiles(statement: &str) -> bool {
    let dir = tempfile::tempdir().expect("a folder for the unit");
    std::fs::write(dir.path().join("header.h"), header("joined")).expect("a writable folder");
    // GCC 12 takes constant addresses in the first page for mistakes, which on dsPIC they are not.
    let bases = "#define JOINED_C1_BASE 0x40000000\n#define JOINED_C2_BASE 0x40001000\n";
    let source = format!(
        "#define JOINED_MICROCHIP_NAMES\n{bases}#include \"header.h\"\nvoid function(void);\nvoid function(void) {{ {statement}; }}\n"
    );
    std::fs::write(dir.path().join("unit.c"), source).expect("a writable folder");
    let status = Command::new("gcc")
        .args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "-o", "unit.o", "unit.c"])
        .current_dir(dir.path())
        .output();
    status.expect("gcc runs; Debian package gcc").status.success()
}

#[test]
fn a_bit_field_of_a_flag_register_can_be_read_and_not_assigned() {
    assert!(compiles("C1TBCLbits.TBC = 3"));
    assert!(compiles("C2RXF1SIDbits.EXIDE = 1"));
    assert!(compiles("C1FLAG1 = (uint16_t)~JOINED_FLAG1_FL_Msk(3U)"));
    assert!(compiles("while (C1FLAG1bits.FL3 == 0) { }"));
    assert!(!compiles("C1FLAG1bits.FL3 = 0"));
    assert!(!compiles("C1REQLbits.RQ3 = 1"));
}
