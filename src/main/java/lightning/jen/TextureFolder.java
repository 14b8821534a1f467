package lightning.jen;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.scene.Texture;
import lightning.text.Quote;

/** Finds the textures of one scene: beside its file or in {@code textures/} ({@link FileFolders}). Each file is decoded once. */
final class TextureFolder {
    static final String NAME = "textures";
    private static final Pattern PICTURE = Pattern.compile(".+\\.(png|jpe?g)", Pattern.CASE_INSENSITIVE);

    private final FileFolders folders;
    private final Map<Path, Texture> decoded = new HashMap<>();
    private long pixels;

    /** @param scene the folder that holds the scene file */
    TextureFolder(Path scene) {
        folders = new FileFolders(scene, "texture", NAME);
    }

    /**
     * The decoded picture.
     *
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of
     *     them, or if it is no PNG or JPEG within {@link JenLimits}
     */
    Texture load(String file) throws UnusableFileException {
        try {
            Path path = folders.find(file);
            Texture known = decoded.get(path);
            if (known != null) {
                return known;
            }
            if (decoded.size() == JenLimits.TEXTURES) {
                throw new UnusableFileException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                        + Quote.of(file));
            }
            Texture texture = TextureDecoder.decode(file, path, JenLimits.ALL_TEXTURE_PIXELS - pixels);
            pixels += (long) texture.width() * texture.height();
            decoded.put(path, texture);
            return texture;
        } catch (IOException | InvalidPathException | SecurityException e) {
            throw new UnusableFileException("texture " + Quote.of(file) + " cannot be read: " + e.getMessage());
        } catch (IllegalArgumentException e) {
            throw new UnusableFileException(e.getMessage());
        }
    }

    /** The pictures that a scene there can name, by the end of their names, in alphabetical order; none of unreadable folders. */
    List<String> names() {
        var names = new TreeSet<String>(String.CASE_INSENSITIVE_ORDER);
        try {
            for (Path folder : folders.all()) {
                try (Stream<Path> files = Files.list(folder)) {
                    files.filter(Files::isRegularFile).map(f -> f.getFileName().toString())
                            .filter(f -> PICTURE.matcher(f).matches()).filter(FileName::isAllowed).forEach(names::add);
                }
            }
        } catch (IOException | UncheckedIOException | SecurityException e) {
            return List.copyOf(names);
        }
        return List.copyOf(names);
    }
}
