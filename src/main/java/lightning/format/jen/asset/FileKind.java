package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.ies.IesReader;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageLimits;
import lightning.format.mesh.MeshException;

/** Kind of asset file that a scene references next to it or in its texture folders. */
public enum FileKind {
    /** Image on a material or on the face of a light, or gobo of a light. */
    TEXTURE(TextureFile.REDUCIBLE) {
        @Override
        void read(String name, Path file) throws IOException {
            TextureFile.read(name, file);
        }
    },
    /** Photometric profile of a light. */
    PROFILE("profile", "an IES file", Messages.key("IES profiles"), List.of("ies")) {
        @Override
        void read(String name, Path file) throws IOException, MeshException {
            IesReader.read(file);
        }
    },
    /** Environment map of a scene. */
    ENVIRONMENT(EnvironmentReader.LIMITS) {
        @Override
        void read(String name, Path file) throws IOException {
            EnvironmentReader.read(name, file, 0, _ -> {});
        }
    };

    private final String noun;
    private final String description;
    private final String title;
    private final List<String> extensions;
    private final Pattern pattern;

    FileKind(ImageLimits limits) {
        this(limits.noun(), limits.description(), limits.formats().stream().map(ImageFormat::name).collect(Collectors.joining(", ")),
                limits.extensions());
    }

    FileKind(String noun, String description, String title, List<String> extensions) {
        this.noun = noun;
        this.description = description;
        this.title = title;
        this.extensions = extensions;
        pattern = Pattern.compile(".+\\.(" + String.join("|", extensions) + ")", Pattern.CASE_INSENSITIVE);
    }

    /** Reads a file as a scene would, with the same exceptions. */
    abstract void read(String name, Path file) throws IOException, MeshException;

    /** Returns the display name of the file formats. */
    public String title() {
        return Messages.tr(title);
    }

    /** Returns a noun phrase for such a file, in English. */
    public String description() {
        return description;
    }

    /** Returns the file extensions, without the dot. */
    public List<String> endings() {
        return extensions;
    }

    /**
     * Returns the names of available files, in alphabetical order; skips unreadable folders.
     *
     * @param scene folder of the scene file
     */
    public List<String> fileNames(Path scene) {
        return searchPath(scene).fileNames(pattern);
    }

    /**
     * Returns the file for a name; empty if it does not exist, or a link leads out of the folders.
     *
     * @param scene folder of the scene file
     * @throws IOException if the folders cannot be read
     * @throws RefusalException if the name is not valid in a scene
     */
    public Optional<Path> find(Path scene, String name) throws IOException {
        try {
            return Optional.of(searchPath(scene).find(name));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** Returns the search path of a scene in a folder. */
    AssetSearchPath searchPath(Path scene) {
        return new AssetSearchPath(scene, noun, TextureFolder.NAME);
    }

    /** Returns whether a file has a name of this kind. */
    public boolean isNamed(Path file) {
        return isNamed(file.getFileName().toString());
    }

    /** Returns whether a name is one of this kind. */
    public boolean isNamed(String name) {
        return pattern.matcher(name).matches();
    }

    /**
     * Checks that a scene could use a file if it were next to it.
     *
     * @throws RefusalException if its name or size is invalid, or it is damaged; the message contains the cause
     */
    void check(Path file) throws IOException {
        String name = file.getFileName().toString();
        FileName.check(noun, name, TextureFolder.NAME);
        String article = noun.startsWith("e") ? "an " : "a ";
        if (!isNamed(name)) {
            throw new RefusalException(article + noun + " must be " + description + ", was " + Quote.of(name));
        }
        if (!Files.isRegularFile(file)) {
            throw new RefusalException(article + noun + " must be a file, was " + Quote.of(name));
        }
        try {
            read(name, file);
        } catch (UnusableFileException | MeshException e) {
            throw new RefusalException(String.valueOf(e.getMessage()), e);
        }
    }
}
