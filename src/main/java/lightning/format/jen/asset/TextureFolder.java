package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageSource;
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
    private final TextureBudget budget = new TextureBudget();

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
     * Loads a texture. One of too many pixels loses rows and columns.
     *
     * @param samples meaning of the samples
     * @param notes receives a clause if the texture is reduced
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, or it is not an
     *     image within {@link JenLimits}
     */
    public Texture load(String file, TextureUsage samples, Consumer<String> notes) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, samples, path, notes));
    }

    private Texture load(String file, TextureUsage samples, Path path, Consumer<String> notes) throws IOException {
        var key = new CacheKey(path, samples);
        Texture cached = cache.get(key);
        if (cached != null) {
            return cached;
        }
        if (cache.size() == JenLimits.TEXTURES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                    + Quote.of(file));
        }
        Texture texture = ImageFile.read(file, path, TextureFile.REDUCIBLE, image -> reduced(file, image, samples, notes));
        cache.put(key, texture);
        return texture;
    }

    private Texture reduced(String file, ImageSource image, TextureUsage samples, Consumer<String> notes) throws IOException {
        long pixels = image.pixelCount();
        long limit = budget.limit(pixels);
        if (limit < 1) {
            throw new UnusableFileException("texture " + Quote.of(file) + " exceeds the limit: all textures together must have at most "
                    + JenLimits.TOTAL_TEXTURE_PIXELS + " pixels");
        }
        Texture texture = image.texture(samples, image.step(limit));
        if (texture.pixels() < pixels) {
            notes.accept(
                    "texture " + Quote.of(file) + " has " + pixels + " pixels; reduced to " + texture.width() + "×" + texture.height());
        }
        budget.use(pixels, texture.pixels());
        if (image.isDisplayReferred() || samples == TextureUsage.EMISSION || texture.max() <= 1) {
            return texture;
        }
        notes.accept("texture " + Quote.of(file) + " has values above 1; limited to 1");
        return texture.limited(1);
    }
}
