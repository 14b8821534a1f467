package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import lightning.base.file.RegularFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.hdr.HdrReader;
import lightning.format.ies.IesReader;
import lightning.format.mesh.MeshException;

/** What a scene names by its file, and finds beside it or among its textures. */
public enum FileKind {
    /** A picture on a material, or one that a light projects. */
    TEXTURE("texture", "a PNG or JPEG file", Messages.key("PNG, JPEG"), JenLimits.TEXTURE_BYTES, "png", "jpg", "jpeg") {
        @Override
        void read(String name, Path file) throws IOException, UnusableFileException {
            TextureDecoder.decodeNumbers(name, RegularFile.readBytes(file, "a PNG or JPEG file", JenLimits.TEXTURE_BYTES));
        }
    },
    /** How strongly a light shines in each direction. */
    PROFILE("profile", "an IES file", Messages.key("IES profiles"), IesReader.MAX_BYTES, "ies") {
        @Override
        void read(String name, Path file) throws IOException, MeshException {
            IesReader.read(file);
        }
    },
    /** What is far around a scene. */
    ENVIRONMENT("environment", "a Radiance HDR file", Messages.key("Radiance HDR"), HdrReader.MAX_BYTES, "hdr") {
        @Override
        void read(String name, Path file) throws IOException, MeshException {
            HdrReader.read(file);
        }
    };

    private final String noun;
    private final String description;
    private final String title;
    private final long maxBytes;
    private final List<String> extensions;
    private final Pattern pattern;

    FileKind(String noun, String description, String title, long maxBytes, String... extensions) {
        this.noun = noun;
        this.description = description;
        this.title = title;
        this.maxBytes = maxBytes;
        this.extensions = List.of(extensions);
        pattern = Pattern.compile(".+\\.(" + String.join("|", extensions) + ")", Pattern.CASE_INSENSITIVE);
    }

    /** Reads a file as a scene would, and throws the same where it cannot. */
    abstract void read(String name, Path file) throws IOException, UnusableFileException, MeshException;

    /** Such files, for people. */
    public String title() {
        return Messages.tr(title);
    }

    /** How their names may end, without the point. */
    public List<String> endings() {
        return extensions;
    }

    /**
     * The names by which a scene would find those that lie there, in alphabetical order; none of unreadable folders.
     *
     * @param scene the folder that holds the scene file
     */
    public List<String> fileNames(Path scene) {
        return searchPath(scene).fileNames(pattern);
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
            return Optional.of(searchPath(scene).find(name));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** Where a scene in a folder looks for them. */
    AssetSearchPath searchPath(Path scene) {
        return new AssetSearchPath(scene, noun, TextureFolder.NAME);
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
            throw new IllegalArgumentException(article + noun + " must be " + description + ", was " + Quote.of(name));
        }
        if (!Files.isRegularFile(file) || Files.size(file) > maxBytes) {
            throw new IllegalArgumentException(
                    article + noun + " must be a file of at most " + maxBytes + " bytes, was " + Quote.of(name));
        }
        try {
            read(name, file);
        } catch (UnusableFileException | MeshException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }
}
