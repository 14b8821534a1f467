package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Loader for the textures of a scene: next to its file or in {@code textures/} ({@link AssetSearchPath}). Each file is
 * decoded once.
 */
public final class TextureFolder {
    public static final String NAME = "textures";

    private final AssetSearchPath searchPath;
    private final Map<CacheKey, Texture> cache = new HashMap<>();
    private long pixels;

    /** File with the meaning of its samples. */
    private record CacheKey(Path path, TextureUsage samples) {}

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    public TextureFolder(Path scene) {
        searchPath = FileKind.TEXTURE.searchPath(scene);
    }

    /** Returns the files that were read. */
    Set<Path> files() {
        return cache.keySet().stream().map(CacheKey::path).collect(Collectors.toSet());
    }

    /**
     * Loads a texture.
     *
     * @param samples meaning of the samples
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, or it is not an
     *     image within {@link JenLimits}
     */
    public Texture load(String file, TextureUsage samples) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, samples, path));
    }

    private Texture load(String file, TextureUsage samples, Path path) throws UnusableFileException, IOException {
        var key = new CacheKey(path, samples);
        Texture cached = cache.get(key);
        if (cached != null) {
            return cached;
        }
        if (cache.size() == JenLimits.TEXTURES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                    + Quote.of(file));
        }
        long pixelsLeft = JenLimits.TOTAL_TEXTURE_PIXELS - pixels;
        Texture texture = samples == TextureUsage.EMISSION ? LightTextureReader.read(file, path, pixelsLeft)
                : TextureDecoder.decode(file, path, samples, pixelsLeft);
        pixels += (long) texture.width() * texture.height();
        cache.put(key, texture);
        return texture;
    }
}
