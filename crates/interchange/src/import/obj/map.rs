//! `Map`: a texture statement of MTL, its options and its file.
//!
//! Source: "MTL material format (Lightwave, OBJ)", Alias|Wavefront, Inc., 1995,
//! section "Options for texture map statements".

use crate::import::mesh::words::Word;

/// What `map_Kd` says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Map {
    /// The file, as it is written.
    pub(super) file: String,
    /// What coordinates are multiplied by (`-s`).
    pub(super) scale: [f64; 2],
    /// What is added to them then (`-o`).
    pub(super) offset: [f64; 2],
    /// Whether the picture is there only once (`-clamp on`).
    pub(super) is_clamped: bool,
    /// Options that are not done, and what they ask for.
    pub(super) lost: Vec<(&'static str, &'static str)>,
}

impl Map {
    /// Reads the words after the keyword; `text` gives what was written from the
    /// first of some to the last, as the name of a file may have spaces.
    ///
    /// # Errors
    /// What is not as the format has it.
    pub(super) fn of<'a>(
        given: &[Word<'a>],
        text: impl FnOnce(&[Word<'a>]) -> &'a [u8],
    ) -> Result<Self, String> {
        let mut map = Self {
            file: String::new(),
            scale: [1.0; 2],
            offset: [0.0; 2],
            is_clamped: false,
            lost: Vec::new(),
        };
        let mut rest = given;
        while let [option, after @ ..] = rest
            && option.text.starts_with(b"-")
        {
            rest = map.option(option, after)?;
        }
        if rest.is_empty() {
            return Err("expected the name of a file, found none".to_owned());
        }
        map.file = String::from_utf8_lossy(text(rest)).into_owned();
        Ok(map)
    }

    /// One option; what is left after its arguments.
    fn option<'w, 'a>(
        &mut self,
        option: &Word<'a>,
        after: &'w [Word<'a>],
    ) -> Result<&'w [Word<'a>], String> {
        let mut lose = |is_lost: bool, option, what| {
            if is_lost {
                self.lost.push((option, what));
            }
        };
        let within = |why: String| format!("{}: {why}", option.shown());
        let lower = option.text.to_ascii_lowercase();
        match &lower[..] {
            b"-s" | b"-o" | b"-t" => {
                // The last word is the file, whatever it looks like.
                let most = after.len().saturating_sub(1).min(3);
                let numbers = after[..most].iter().map_while(|word| word.number().ok());
                let numbers: Vec<f64> = numbers.collect();
                let Some(&u) = numbers.first() else {
                    return Err(within("expected one to three numbers, found none".to_owned()));
                };
                let default = if lower == b"-s" { 1.0 } else { 0.0 };
                let pair = [u, numbers.get(1).copied().unwrap_or(default)];
                match &lower[..] {
                    b"-s" => self.scale = pair,
                    b"-o" => self.offset = pair,
                    _ => lose(numbers.iter().any(|&x| x != 0.0), "-t", "turbulence"),
                }
                Ok(&after[numbers.len()..])
            }
            b"-mm" => {
                let [base, gain, rest @ ..] = after else {
                    return Err(within("expected two numbers".to_owned()));
                };
                let pair = [base.number().map_err(within)?, gain.number().map_err(within)?];
                lose(pair != [0.0, 1.0], "-mm", "a range of values of its own");
                Ok(rest)
            }
            b"-clamp" | b"-blendu" | b"-blendv" | b"-cc" => {
                let [word, rest @ ..] = after else {
                    return Err(within("expected on or off".to_owned()));
                };
                let is_on = match &word.text.to_ascii_lowercase()[..] {
                    b"on" => true,
                    b"off" => false,
                    _ => {
                        return Err(within(format!(
                            "expected on or off, found \"{}\"",
                            word.shown()
                        )));
                    }
                };
                match &lower[..] {
                    b"-clamp" => self.is_clamped = is_on,
                    b"-cc" => lose(is_on, "-cc", "a correction of colors"),
                    b"-blendu" => lose(!is_on, "-blendu", "a texture without smoothing"),
                    _ => lose(!is_on, "-blendv", "a texture without smoothing"),
                }
                Ok(rest)
            }
            b"-texres" | b"-boost" | b"-bm" | b"-imfchan" | b"-type" => {
                let [_, rest @ ..] = after else {
                    return Err(within("expected a word after it, found none".to_owned()));
                };
                let (name, what) = match &lower[..] {
                    b"-texres" => ("-texres", "a resolution of its own"),
                    b"-boost" => ("-boost", "a sharpness of its own"),
                    b"-bm" => ("-bm", "a strength of relief"),
                    b"-imfchan" => ("-imfchan", "one channel alone"),
                    _ => ("-type", "a shape to be laid around"),
                };
                lose(true, name, what);
                Ok(rest)
            }
            _ => Err(format!(
                "expected an option such as -s, -o or -clamp, or the name of a file, found \"{}\"",
                option.shown()
            )),
        }
    }
}
