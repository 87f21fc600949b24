#![allow(missing_docs)]
mod architecture;
#[path = "exact/characteristic.rs"]
mod characteristic;
mod common;
#[path = "float/extremal.rs"]
mod extremal;
#[path = "joint/mod.rs"]
mod joint;
#[path = "smoothness/mod.rs"]
mod smoothness;
mod cli_mine {
    use snapbox::cmd::{Command, cargo_bin};

    fn subcert<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Command {
        Command::new(cargo_bin!("subcert"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env_remove("COLUMNS")
            .args(arguments)
    }
    fn refused<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
        let assert = subcert(arguments).assert().code(2);
        String::from_utf8_lossy(&assert.get_output().stderr).into_owned()
    }
    fn written<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
        let assert = subcert(arguments).assert().success();
        String::from_utf8_lossy(&assert.get_output().stdout).into_owned()
    }
    fn assert_parts(message: &str, parts: &[&str]) {
        for part in parts {
            assert!(message.contains(part), "no `{part}` in: {message}");
        }
    }
    struct TemporaryFile(std::path::PathBuf);
    impl TemporaryFile {
        fn new(name: &str, text: &str) -> TemporaryFile {
            let path = std::env::temp_dir().join(format!("subcert-{}-{name}", std::process::id()));
            std::fs::write(&path, text).expect("a temporary file");
            TemporaryFile(path)
        }
        fn path(&self) -> &str {
            self.0.to_str().expect("a UTF-8 path")
        }
    }
    #[path = "/tmp/wt/smooth/tests/cli/smoothness.rs"]
    mod smoothness;
}
