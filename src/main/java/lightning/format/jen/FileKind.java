package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import lightning.base.file.OrdinaryFile;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.format.hdr.HdrReader;
import lightning.format.ies.IesReader;
import lightning.format.mesh.MeshException;

/** What a scene names by its file, and finds beside it or among its textures. */
public enum FileKind {
    /** A picture on a material, or one that a light projects. */
    TEXTURE("texture", "a PNG or JPEG file", Texts.key("PNG, JPEG"), JenLimits.TEXTURE_BYTES, "png", "jpg", "jpeg") {
        @Override
        void read(String name, Path file) throws IOException, UnusableFileException {
            TextureDecoder.numbers(name, OrdinaryFile.bytes(file, "a PNG or JPEG file", JenLimits.TEXTURE_BYTES));
        }
    },
    /** How strongly a light shines in each direction. */
    PROFILE("profile", "an IES file", Texts.key("IES profiles"), IesReader.BYTES, "ies") {
        @Override
        void read(String name, Path file) throws IOException, MeshException {
            IesReader.read(file);
        }
    },
    /** What is far around a scene. */
    ENVIRONMENT("environment", "a Radiance HDR file", Texts.key("Radiance HDR"), HdrReader.BYTES, "hdr") {
        @Override
        void read(String name, Path file) throws IOException, MeshException {
            HdrReader.read(file);
        }
    };

    private final String noun;
    private final String form;
    private final String title;
    private final long mostBytes;
    private final List<String> endings;
    private final Pattern pattern;

    FileKind(String noun, String form, String title, long mostBytes, String... endings) {
        this.noun = noun;
        this.form = form;
        this.title = title;
        this.mostBytes = mostBytes;
        this.endings = List.of(endings);
        pattern = Pattern.compile(".+\\.(" + String.join("|", endings) + ")", Pattern.CASE_INSENSITIVE);
    }

    /** Reads a file as a scene would, and throws the same where it cannot. */
    abstract void read(String name, Path file) throws IOException, UnusableFileException, MeshException;

    /** Such files, for people. */
    public String title() {
        return Texts.of(title);
    }

    /** How their names may end, without the point. */
    public List<String> endings() {
        return endings;
    }

    /**
     * The names by which a scene would find those that lie there, in alphabetical order; none of unreadable folders.
     *
     * @param scene the folder that holds the scene file
     */
    public List<String> names(Path scene) {
        return folders(scene).names(pattern);
    }

    /**
     * Where a scene finds the one of a name; empty where there is none, or a link leads out of the folders.
     *
     * @param scene the folder that holds the scene file
     * @throws IOException              if the folders cannot be read
     * @throws IllegalArgumentException if no scene can name it so
     */
    public Optional<Path> find(Path scene, String name) throws IOException {
        try {
            return Optional.of(folders(scene).find(name));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** Where a scene in a folder looks for them. */
    FileFolders folders(Path scene) {
        return new FileFolders(scene, noun, TextureFolder.NAME);
    }

    /**
     * That a scene could have a file, were it beside it.
     *
     * @throws IllegalArgumentException if not: by its name, its size, or because it is damaged; the message says which
     */
    void check(Path file) throws IOException {
        String name = file.getFileName().toString();
        FileName.check(noun, name, TextureFolder.NAME);
        String article = noun.startsWith("e") ? "an " : "a ";
        if (!pattern.matcher(name).matches()) {
            throw new IllegalArgumentException(article + noun + " must be " + form + ", was " + Quote.of(name));
        }
        if (!Files.isRegularFile(file) || Files.size(file) > mostBytes) {
            throw new IllegalArgumentException(
                    article + noun + " must be a file of at most " + mostBytes + " bytes, was " + Quote.of(name));
        }
        try {
            read(name, file);
        } catch (UnusableFileException | MeshException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }
}
