package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.scene.SampleMeaning;
import lightning.scene.Texture;

/** Finds the textures of one scene: beside its file or in {@code textures/} ({@link FileFolders}). Each file is decoded once. */
final class TextureFolder {
    static final String NAME = "textures";

    private final FileFolders folders;
    private final Map<Decoded, Texture> decoded = new HashMap<>();
    private long pixels;

    /** A file, and what its samples were taken for. */
    private record Decoded(Path path, SampleMeaning samples) {}

    /** @param scene the folder that holds the scene file */
    TextureFolder(Path scene) {
        folders = FileKind.TEXTURE.folders(scene);
    }

    /**
     * The decoded picture.
     *
     * @param samples what its samples stand for
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of
     *     them, or if it is no PNG or JPEG within {@link JenLimits}
     */
    Texture load(String file, SampleMeaning samples) throws UnusableFileException {
        return folders.read(file, path -> load(file, samples, path));
    }

    private Texture load(String file, SampleMeaning samples, Path path) throws UnusableFileException, IOException {
        var wanted = new Decoded(path, samples);
        Texture known = decoded.get(wanted);
        if (known != null) {
            return known;
        }
        if (decoded.size() == JenLimits.TEXTURES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                    + Quote.of(file));
        }
        Texture texture = TextureDecoder.decode(file, path, samples, JenLimits.ALL_TEXTURE_PIXELS - pixels);
        pixels += (long) texture.width() * texture.height();
        decoded.put(wanted, texture);
        return texture;
    }
}
