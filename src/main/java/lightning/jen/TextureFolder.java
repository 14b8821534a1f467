package lightning.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import lightning.scene.Texture;
import lightning.text.Quote;

/** Finds the textures of one scene: beside its file or in {@code textures/} ({@link FileFolders}). Each file is decoded once. */
final class TextureFolder {
    static final String NAME = "textures";
    static final Pattern PICTURE = Pattern.compile(".+\\.(png|jpe?g)", Pattern.CASE_INSENSITIVE);

    private final FileFolders folders;
    private final Map<Decoded, Texture> decoded = new HashMap<>();
    private long pixels;

    /** A file, and whether its samples were taken as colours. */
    private record Decoded(Path path, boolean color) {}

    /** @param scene the folder that holds the scene file */
    TextureFolder(Path scene) {
        folders = new FileFolders(scene, "texture", NAME);
    }

    /**
     * The decoded picture.
     *
     * @param color whether its samples are colours; else they are numbers, and are not decoded
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of
     *     them, or if it is no PNG or JPEG within {@link JenLimits}
     */
    Texture load(String file, boolean color) throws UnusableFileException {
        return folders.read(file, path -> load(file, color, path));
    }

    private Texture load(String file, boolean color, Path path) throws UnusableFileException, IOException {
        var wanted = new Decoded(path, color);
        Texture known = decoded.get(wanted);
        if (known != null) {
            return known;
        }
        if (decoded.size() == JenLimits.TEXTURES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                    + Quote.of(file));
        }
        Texture texture = TextureDecoder.decode(file, path, color, JenLimits.ALL_TEXTURE_PIXELS - pixels);
        pixels += (long) texture.width() * texture.height();
        decoded.put(wanted, texture);
        return texture;
    }

    /** The pictures that a scene there can name, by the end of their names, in alphabetical order; none of unreadable folders. */
    List<String> names() {
        return folders.names(PICTURE);
    }
}
