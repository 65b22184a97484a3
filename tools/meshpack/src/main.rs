//! The command: packs a mesh or an image, or makes the repository's own.

use clap::{Args, Parser, Subcommand};
use meshpack::{Error, generated, read_mesh, read_texture, write_all};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use topleft::Wrap;

/// Packs meshes and images for topleft, as a const Rust file or as a blob that firmware reads in place.
#[derive(Parser)]
#[command(version)]
struct Options {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Packs an OBJ or STL file and reports the error that quantising makes.
    Mesh {
        /// The mesh: FILE.obj or FILE.stl.
        file: PathBuf,
        /// Multiply all coordinates by this.
        #[arg(long, value_parser = positive, conflicts_with = "fit", value_name = "FACTOR")]
        scale: Option<f64>,
        /// Centre the mesh, and scale it so that its longest side goes from -HALF to HALF.
        #[arg(long, value_parser = positive, value_name = "HALF")]
        fit: Option<f64>,
        /// Pack a normal for each face too, for flat light.
        #[arg(long)]
        face_normals: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Packs a PNG, JPEG or BMP file whose sizes are powers of two up to 1024.
    Texture {
        /// The image.
        file: PathBuf,
        /// Show the outermost texels beyond the edges, and not the texture again.
        #[arg(long)]
        clamp: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Makes the meshes and textures of the scenes again.
    Make {
        /// The folder that gets the folders `mesh` and `texture`.
        #[arg(long, value_name = "FOLDER", default_value = "scenes/src")]
        out: PathBuf,
    },
}

#[derive(Args)]
struct Output {
    /// Write a Rust file with a constant.
    #[arg(long, value_name = "FILE")]
    rust: Option<PathBuf>,
    /// Write a binary file that the library reads in place.
    #[arg(long, value_name = "FILE")]
    blob: Option<PathBuf>,
    /// The constant's name [default: the file's name in capitals].
    #[arg(long, value_parser = constant_name)]
    name: Option<String>,
}

fn main() -> ExitCode {
    match run(Options::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> Result<(), Error> {
    match command {
        Command::Mesh { file, scale, fit, face_normals, output } => {
            let mut model = read_mesh(&file)?;
            for warning in &model.warnings {
                eprintln!("warning: {warning}");
            }
            model = model.scale(scale.unwrap_or(1.0));
            if let Some(half) = fit {
                model = model.fit(half);
            }
            if face_normals {
                model = model.with_face_normals();
            }
            let packed = model.quantise()?;
            output.write(&file, |name, doc| packed.to_rust(name, doc), || packed.to_blob())?;
            println!("{packed}");
            if model.dropped > 0 {
                println!("left out        {} faces without area", model.dropped);
            }
            for texture in &model.textures {
                println!("texture         {}", texture.display());
            }
        }
        Command::Texture { file, clamp, output } => {
            let packed = read_texture(&file)?.with_wrap(if clamp { Wrap::Clamp } else { Wrap::Repeat });
            output.write(&file, |name, doc| packed.to_rust(name, doc), || packed.to_blob())?;
            let texture = packed.texture();
            println!("texels          {}x{}", texture.width(), texture.height());
            println!("flash           {} bytes", packed.bytes());
        }
        Command::Make { out } => {
            let files: Vec<_> =
                generated().into_iter().map(|(path, text)| (out.join(path), text.into_bytes())).collect();
            for folder in files.iter().filter_map(|(path, _)| path.parent()) {
                fs::create_dir_all(folder).map_err(|reason| Error::Write(folder.into(), reason))?;
            }
            write_all(&files)?;
            for (path, _) in files {
                println!("{}", path.display());
            }
        }
    }
    Ok(())
}

impl Output {
    fn write(
        &self,
        file: &Path,
        to_rust: impl Fn(&str, &str) -> String,
        to_blob: impl Fn() -> Vec<u8>,
    ) -> Result<(), Error> {
        let name = self.name.clone().unwrap_or_else(|| name_of(file));
        let file_name = file.file_name().unwrap_or_default().to_string_lossy();
        let doc =
            format!("`{name}`, from `{}`.", file_name.replace(|c: char| c.is_control() || c == '`', "_"));
        let rust = self.rust.iter().map(|path| (path.clone(), to_rust(&name, &doc).into_bytes()));
        let blob = self.blob.iter().map(|path| (path.clone(), to_blob()));
        write_all(&rust.chain(blob).collect::<Vec<_>>())
    }
}

/// A constant's name made of a file's: capitals, digits and underscores.
fn name_of(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    let name: String = stem.chars().map(letter).collect();
    if name.starts_with(|c: char| c.is_ascii_uppercase()) { name } else { format!("MESH_{name}") }
}

fn constant_name(text: &str) -> Result<String, String> {
    let starts = text.starts_with(|c: char| c.is_ascii_alphabetic());
    if starts && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        Ok(text.into())
    } else {
        Err("a constant's name has letters, digits and underscores, and starts with a letter".into())
    }
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("a finite number above 0 is needed".into()),
    }
}
