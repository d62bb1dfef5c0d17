//! A review as JSON.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::{Decision, Review};

impl Review {
    /// `{"schema":1,"decisions":{name:"accepted"|"rejected"},"can_accept":[name],
    /// "can_undo":[name],"messages":[sentence]}`.
    pub fn to_json(&self, messages: &[String]) -> Value {
        let word = |(name, decision): (&String, &Decision)| match decision {
            Decision::Accepted => (name.clone(), json!("accepted")),
            Decision::Rejected => (name.clone(), json!("rejected")),
        };
        let can_undo = self.decided.keys().chain(self.accepted.keys()).collect::<BTreeSet<_>>();
        let can_accept: Vec<_> = self.steps.keys().filter(|name| self.can_accept(name)).collect();
        json!({
            "schema": 1,
            "decisions": Value::Object(self.decided.iter().map(word).collect()),
            "can_accept": can_accept,
            "can_undo": can_undo,
            "messages": messages,
        })
    }
}
