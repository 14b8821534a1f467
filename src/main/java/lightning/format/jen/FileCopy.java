package lightning.format.jen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.OrdinaryFile;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;

/** Brings a file from elsewhere into the textures beside a scene, where scenes find it by its name. */
public final class FileCopy {
    private static final String EXPECTED = "a file for the textures of a scene";

    private FileCopy() {}

    /** What came of it. */
    public sealed interface Outcome {
        /** @param file the name by which the scene finds it */
        String file();
    }

    /** It is there. */
    public record Brought(String file) implements Outcome {}

    /** Another file has that name; nothing was written. */
    public record Taken(String file) implements Outcome {}

    /**
     * Copies a file, unless the scene finds it already.
     *
     * @param scene     the folder that holds the scene file
     * @param overwrite whether another file of that name may be replaced
     * @throws IllegalArgumentException if the scene could not have it, by its name, its size or what it holds, or if the folder of textures
     *                                  is a link
     */
    public static Outcome bring(FileKind kind, Path file, Path scene, boolean overwrite) throws IOException {
        kind.check(file);
        String name = file.getFileName().toString();
        Path textures = textures(kind, scene);
        Path real = file.toRealPath();
        for (Path beside : List.of(scene.resolve(name), textures.resolve(name))) {
            if (Files.exists(beside) && beside.toRealPath().equals(real)) {
                return new Brought(name);
            }
        }
        return copy(real, scene, textures.resolve(name), overwrite);
    }

    /** Where scenes there look for textures; where there is no such folder yet, one beside the scene. */
    private static Path textures(FileKind kind, Path scene) throws IOException {
        List<Path> folders = kind.folders(scene).all();
        Path textures = folders.size() > 1 ? folders.getLast() : Files.createDirectories(folders.getFirst().resolve(TextureFolder.NAME));
        if (!textures.toRealPath().equals(textures)) {
            throw new IllegalArgumentException("the folder of textures must be no link, was one to " + textures.toRealPath());
        }
        return textures;
    }

    private static Outcome copy(Path file, Path scene, Path to, boolean overwrite) throws IOException {
        String name = to.getFileName().toString();
        Path hiding = scene.resolve(name);
        if (Files.exists(hiding) && !OrdinaryFile.areSame(file, hiding, EXPECTED)) {
            throw new IllegalArgumentException("another file " + Quote.of(name) + " lies beside the scene and would be found first");
        }
        if (Files.isSymbolicLink(to)) {
            throw new IllegalArgumentException(Quote.of(name) + " in the folder of textures is a link; it is not written over");
        }
        if (Files.exists(to)) {
            if (OrdinaryFile.areSame(file, to, EXPECTED)) {
                return new Brought(name);
            }
            if (!overwrite) {
                return new Taken(name);
            }
        }
        SafeFile.write(to, out -> {
            try (InputStream in = OrdinaryFile.open(file, EXPECTED)) {
                in.transferTo(out);
            }
        });
        return new Brought(name);
    }
}
