package lightning.format.jen.asset;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/** Copies an external file to the textures of a scene, where the scene finds it by name. */
public final class FileCopy {
    private static final String EXPECTED_FILE = "a file for the textures of a scene";

    private FileCopy() {}

    /** Outcome of a copy. */
    public sealed interface Outcome {
        /** Returns the file name for the scene. */
        String file();
    }

    /** The file is available to the scene. */
    public record Copied(String file) implements Outcome {}

    /** A different file has that name; nothing was written. */
    public record NameConflict(String file) implements Outcome {}

    /**
     * Copies a file, unless the scene already finds it.
     *
     * @param scene folder of the scene file
     * @param overwrite true to replace a different file of that name
     * @throws RefusalException if a scene cannot use it because of its name, size or content, or if the texture
     *     folder is a link
     */
    public static Outcome copyToScene(FileKind kind, Path file, Path scene, boolean overwrite) throws IOException {
        kind.check(file);
        String name = file.getFileName().toString();
        Path textureFolder = textureFolder(kind, scene);
        Path real = file.toRealPath();
        for (Path candidate : List.of(scene.resolve(name), textureFolder.resolve(name))) {
            if (Files.exists(candidate) && candidate.toRealPath().equals(real)) {
                return new Copied(name);
            }
        }
        return copy(real, scene, textureFolder.resolve(name), overwrite);
    }

    /** Returns the texture folder of a scene; a new one next to the scene if none exists. */
    private static Path textureFolder(FileKind kind, Path scene) throws IOException {
        List<Path> folders = kind.searchPath(scene).folders();
        Path textureFolder =
                folders.size() > 1 ? folders.getLast() : Files.createDirectories(folders.getFirst().resolve(TextureFolder.NAME));
        if (!textureFolder.toRealPath().equals(textureFolder)) {
            throw new RefusalException("the texture folder must not be a link, was a link to " + textureFolder.toRealPath());
        }
        return textureFolder;
    }

    private static Outcome copy(Path file, Path scene, Path target, boolean overwrite) throws IOException {
        String name = target.getFileName().toString();
        Path shadowingFile = scene.resolve(name);
        if (Files.exists(shadowingFile) && !RegularFile.haveSameContent(file, shadowingFile, EXPECTED_FILE)) {
            throw new RefusalException("another file " + Quote.of(name) + " is next to the scene and would be used instead");
        }
        if (Files.isSymbolicLink(target)) {
            throw new RefusalException(Quote.of(name) + " in the texture folder is a link; it is not overwritten");
        }
        if (Files.exists(target)) {
            if (RegularFile.haveSameContent(file, target, EXPECTED_FILE)) {
                return new Copied(name);
            }
            if (!overwrite) {
                return new NameConflict(name);
            }
        }
        AtomicFile.write(target, out -> {
            try (InputStream in = RegularFile.open(file, EXPECTED_FILE)) {
                in.transferTo(out);
            }
        });
        return new Copied(name);
    }
}
