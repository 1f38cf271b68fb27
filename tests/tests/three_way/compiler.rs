//! The C and C++ compilers of Debian.

use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

/// A compiler and the package that brings it.
pub struct Compiler {
    /// Name of the program.
    pub program: &'static str,
    /// Debian package.
    package: &'static str,
    /// Ending of a source file.
    ending: &'static str,
    /// What it needs beside the warnings.
    options: &'static [&'static str],
    /// Dialects to compile in.
    pub dialects: &'static [&'static str],
}

const C: &[&str] = &["-std=c99", "-std=c11"];

/// All compilers that a header has to please. The cross compilers are used without a C library.
pub const COMPILERS: &[Compiler] = &[
    Compiler { program: "gcc", package: "gcc", ending: "c", options: &[], dialects: C },
    Compiler { program: "g++", package: "g++", ending: "cpp", options: &[], dialects: &["-std=c++11", "-std=c++17"] },
    Compiler {
        program: "arm-none-eabi-gcc",
        package: "gcc-arm-none-eabi",
        ending: "c",
        options: &["-ffreestanding"],
        dialects: C,
    },
    Compiler {
        program: "mipsel-linux-gnu-gcc",
        package: "gcc-mipsel-linux-gnu",
        ending: "c",
        options: &["-ffreestanding"],
        dialects: C,
    },
    Compiler {
        program: "avr-gcc",
        package: "gcc-avr",
        ending: "c",
        options: &["-ffreestanding", "-mmcu=atmega128"],
        dialects: C,
    },
];

impl Compiler {
    /// It compiles C++.
    pub fn is_cpp(&self) -> bool {
        self.ending == "cpp"
    }

    /// Compiles a source file beside its headers, with all warnings as errors, and gives the object file.
    pub fn compile(&self, dir: &Path, headers: &[(&str, &str)], source: &str, dialect: &str, what: &str) -> Vec<u8> {
        for (name, text) in headers {
            std::fs::write(dir.join(name), text).expect("a writable folder");
        }
        let input = dir.join(format!("unit.{}", self.ending));
        let object = dir.join("unit.o");
        std::fs::write(&input, source).expect("a writable folder");
        let output = Command::new(self.program)
            .args([dialect, "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "-o"])
            .arg(&object)
            .args(self.options)
            .arg(&input)
            .output();
        let output = match output {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                panic!("{} is missing: install the Debian package {}", self.program, self.package)
            }
            other => other.expect("the compiler runs"),
        };
        let errors = String::from_utf8_lossy(&output.stderr);
        let first: Vec<&str> = errors.lines().take(40).collect();
        assert!(output.status.success(), "{} does not accept {what}:\n{}", self.program, first.join("\n"));
        std::fs::read(&object).expect("the compiler has written an object file")
    }
}
