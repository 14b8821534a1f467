package lightning.format.jen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;

/** Brings a file from elsewhere into the textures beside a scene, where scenes find it by its name. */
public final class FileCopy {
    private static final String EXPECTED_FILE = "a file for the textures of a scene";

    private FileCopy() {}

    /** What came of it. */
    public sealed interface Outcome {
        /** @param file the name by which the scene finds it */
        String file();
    }

    /** It is there. */
    public record Copied(String file) implements Outcome {}

    /** Another file has that name; nothing was written. */
    public record NameConflict(String file) implements Outcome {}

    /**
     * Copies a file, unless the scene finds it already.
     *
     * @param scene     the folder that holds the scene file
     * @param overwrite whether another file of that name may be replaced
     * @throws IllegalArgumentException if the scene could not have it, by its name, its size or what it holds, or if the folder of textures
     *                                  is a link
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

    /** Where scenes there look for textures; where there is no such folder yet, one beside the scene. */
    private static Path textureFolder(FileKind kind, Path scene) throws IOException {
        List<Path> folders = kind.searchPath(scene).folders();
        Path textureFolder =
                folders.size() > 1 ? folders.getLast() : Files.createDirectories(folders.getFirst().resolve(TextureFolder.NAME));
        if (!textureFolder.toRealPath().equals(textureFolder)) {
            throw new IllegalArgumentException("the folder of textures must be no link, was one to " + textureFolder.toRealPath());
        }
        return textureFolder;
    }

    private static Outcome copy(Path file, Path scene, Path target, boolean overwrite) throws IOException {
        String name = target.getFileName().toString();
        Path shadowingFile = scene.resolve(name);
        if (Files.exists(shadowingFile) && !RegularFile.haveSameContent(file, shadowingFile, EXPECTED_FILE)) {
            throw new IllegalArgumentException("another file " + Quote.of(name) + " lies beside the scene and would be found first");
        }
        if (Files.isSymbolicLink(target)) {
            throw new IllegalArgumentException(Quote.of(name) + " in the folder of textures is a link; it is not written over");
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
