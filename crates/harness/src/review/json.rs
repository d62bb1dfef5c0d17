//! A review as JSON.

use serde_json::{Value, json};

use super::{Decision, Review};

impl Review {
    /// `{"schema":1,"decisions":{name:"accepted"|"rejected"},"can_accept":[name],
    /// "messages":[sentence]}`.
    pub fn to_json(&self, messages: &[String]) -> Value {
        let word = |name: &String| match self.decision(name)? {
            Decision::Accepted => Some((name.clone(), json!("accepted"))),
            Decision::Rejected => Some((name.clone(), json!("rejected"))),
        };
        let can_accept: Vec<_> = self.steps.keys().filter(|name| self.can_accept(name)).collect();
        json!({
            "schema": 1,
            "decisions": Value::Object(self.decided.keys().filter_map(word).collect()),
            "can_accept": can_accept,
            "messages": messages,
        })
    }
}
