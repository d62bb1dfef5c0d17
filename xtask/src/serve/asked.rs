//! `Asked`: what a request wants to have decided.

use serde_json::Value;

use super::request::Refusal;

/// What is asked for, by a page of which edition.
#[derive(Debug)]
pub(super) struct Asked {
    pub(super) names: Vec<String>,
    pub(super) edition: String,
}

/// `{"names":["a/b",...],"edition":"..."}`.
///
/// # Errors
/// Anything else.
pub(super) fn asked(body: &[u8]) -> Result<Asked, Refusal> {
    let expected = "expected {\"names\": [...], \"edition\": \"...\"} with names of fixtures";
    let refusal = Refusal(400, expected);
    let value: Value = serde_json::from_slice(body).map_err(|_| refusal)?;
    let object = value.as_object().filter(|object| object.len() == 2).ok_or(refusal)?;
    let text = |value: &Value| value.as_str().map(str::to_owned);
    let edition = object.get("edition").and_then(text).ok_or(refusal)?;
    let names = object.get("names").and_then(Value::as_array).ok_or(refusal)?;
    let names = names.iter().map(text).collect::<Option<_>>().ok_or(refusal)?;
    Ok(Asked { names, edition })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_is_names_and_nothing_else() {
        #[track_caller]
        fn check(body: &str, expected: Option<&[&str]>) {
            let found = asked(body.as_bytes()).ok().map(|asked| asked.names);
            assert_eq!(
                found.as_deref(),
                expected.map(|e| e.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>()).as_deref(),
                "{body}"
            );
        }
        check(r#"{"names":["a/b","c"],"edition":"1"}"#, Some(&["a/b", "c"]));
        check(r#"{"edition":"1","names":[]}"#, Some(&[]));
        for body in [
            "",
            "a",
            "{}",
            r#"{"names":[]}"#,
            r#"{"names":"a","edition":"1"}"#,
            r#"{"names":[1],"edition":"1"}"#,
            r#"{"names":[],"edition":1}"#,
            r#"{"names":[],"edition":"1","x":1}"#,
        ] {
            check(body, None);
        }
        assert!(asked(b"\xff").is_err());
        assert!(asked("[".repeat(1 << 20).as_bytes()).is_err(), "nor does it take the stack");
    }
}
