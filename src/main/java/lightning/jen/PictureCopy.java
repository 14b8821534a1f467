package lightning.jen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.file.SafeFile;
import lightning.text.Quote;

/** Brings a picture from elsewhere into the textures beside a scene, where scenes find it by its name. */
public final class PictureCopy {
    /** More than any picture that a scene may have, bytes. */
    private static final long MOST = 1L << 30;

    private PictureCopy() {}

    /** What came of it. */
    public sealed interface Outcome {
        /** @param file the name by which the scene finds the picture */
        String file();
    }

    /** The picture is there. */
    public record Brought(String file) implements Outcome {}

    /** Another picture has that name; nothing was written. */
    public record Taken(String file) implements Outcome {}

    /**
     * Copies a picture, unless the scene finds it already.
     *
     * @param scene     the folder that holds the scene file
     * @param overwrite whether another picture of that name may be replaced
     * @throws IllegalArgumentException if the file's name is none that a scene can write, if it is no PNG or JPEG by its name, or if
     *     the folder of textures is a link
     */
    public static Outcome bring(Path picture, Path scene, boolean overwrite) throws IOException {
        String name = picture.getFileName().toString();
        FileName.check("texture", name, TextureFolder.NAME);
        if (!TextureFolder.PICTURE.matcher(name).matches()) {
            throw new IllegalArgumentException("a texture must be a PNG or JPEG file, was " + Quote.of(name));
        }
        if (!Files.isRegularFile(picture) || Files.size(picture) > MOST) {
            throw new IllegalArgumentException(String.format(Locale.ROOT, "a texture must be a file of at most %d MB, was %s", MOST >> 20,
                    Quote.of(name)));
        }
        Path textures = textures(scene);
        Path real = picture.toRealPath();
        for (Path beside : List.of(scene.resolve(name), textures.resolve(name))) {
            if (Files.exists(beside) && beside.toRealPath().equals(real)) {
                return new Brought(name);
            }
        }
        return copy(real, scene, textures.resolve(name), overwrite);
    }

    /** Where scenes there look for textures; where there is no such folder yet, one beside the scene. */
    private static Path textures(Path scene) throws IOException {
        List<Path> folders = new FileFolders(scene, "texture", TextureFolder.NAME).all();
        Path textures = folders.size() > 1 ? folders.getLast() : Files.createDirectories(folders.getFirst().resolve(TextureFolder.NAME));
        if (!textures.toRealPath().equals(textures)) {
            throw new IllegalArgumentException("the folder of textures must be no link, was one to " + textures.toRealPath());
        }
        return textures;
    }

    private static Outcome copy(Path picture, Path scene, Path to, boolean overwrite) throws IOException {
        String name = to.getFileName().toString();
        Path hiding = scene.resolve(name);
        if (Files.exists(hiding) && Files.mismatch(picture, hiding) >= 0) {
            throw new IllegalArgumentException("another picture " + Quote.of(name) + " lies beside the scene and would be found first");
        }
        if (Files.isSymbolicLink(to)) {
            throw new IllegalArgumentException(Quote.of(name) + " in the folder of textures is a link; it is not written over");
        }
        if (Files.exists(to)) {
            if (Files.mismatch(picture, to) < 0) {
                return new Brought(name);
            }
            if (!overwrite) {
                return new Taken(name);
            }
        }
        SafeFile.write(to, out -> Files.copy(picture, out));
        return new Brought(name);
    }
}
