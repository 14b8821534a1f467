package lightning.format.exchange.assembly;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import java.util.function.UnaryOperator;
import lightning.base.file.RegularFile;
import lightning.base.file.UnusableFileException;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageLimits;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;

/**
 * Images of an imported scene. No image refuses a scene: one that is missing, of an unknown format or damaged is left out, those that are
 * too large are reduced. Each is noted.
 */
public final class ImageImport {
    /** Images that become PNG files. */
    static final ImageLimits CONVERTED = new ImageLimits("image",
            List.of(ImageFormat.WEBP, ImageFormat.TGA, ImageFormat.BMP, ImageFormat.GIF, ImageFormat.TIFF), JenLimits.TEXTURE_BYTES,
            JenLimits.TEXTURE_SIDE, TextureFile.REDUCIBLE.maxPixels());

    private final SceneAssembler assembler;
    private final Path source;
    private final ConversionNotes notes;
    /** Names in the scene, by reference or name of an embedded image; empty for unusable images. */
    private final Map<String, Optional<String>> names = new HashMap<>();
    /** Used images, by their name in the scene. */
    private final Map<String, UsedImage> used = new LinkedHashMap<>();

    ImageImport(SceneAssembler assembler, Path source) {
        this.assembler = assembler;
        this.source = source;
        notes = assembler.notes;
    }

    /** Returns a texture of an image file that the imported file names; empty if it cannot be used. */
    public Optional<TextureMap> file(String reference, TextureUsage usage) throws IOException {
        if (!names.containsKey(reference)) {
            names.put(reference, importFile(reference));
        }
        return texture(names.get(reference), usage);
    }

    /**
     * Returns a texture of an image that is embedded in the imported file; empty if it cannot be used.
     *
     * @param stem name for its file, unique for each image
     */
    public Optional<TextureMap> embedded(String stem, byte[] bytes, TextureUsage usage) throws IOException {
        if (!names.containsKey(stem)) {
            names.put(stem, usable(bytes).map(image -> useBytes(stem, image)));
        }
        return texture(names.get(stem), usage);
    }

    /** Returns a file that the imported file names, in its folder and below; empty if there is none. */
    public Optional<Path> find(String reference) throws IOException {
        return NearbyFile.of(source).find(reference);
    }

    /** Returns the content of an image file that the imported file names; empty if it is missing or larger than a texture may be. */
    public Optional<byte[]> bytes(String reference) throws IOException {
        Optional<Path> file = NearbyFile.of(source).find(reference);
        return file.isEmpty() || Files.size(file.get()) > JenLimits.TEXTURE_BYTES ? Optional.empty() : Optional.of(read(file.get()));
    }

    private Optional<String> importFile(String reference) throws IOException {
        Optional<Path> file = NearbyFile.of(source).find(reference);
        if (file.isEmpty()) {
            notes.add("textures that are missing");
            return Optional.empty();
        }
        if (Files.size(file.get()) > JenLimits.TEXTURE_BYTES) {
            notes.add("textures of more than 64 MiB");
            return Optional.empty();
        }
        byte[] bytes = read(file.get());
        return usable(bytes).map(image -> image.bytes == bytes ? use(assembler.addFile(file.get()), image.pixels, () -> read(file.get()))
                : useBytes(stem(file.get().getFileName().toString()), image));
    }

    private String useBytes(String stem, Usable image) {
        return use(assembler.addFile(stem + (isPng(image.bytes) ? ".png" : ".jpg"), image.bytes), image.pixels, () -> image.bytes);
    }

    /** Content of an image that a scene can use, and its number of pixels. */
    private record Usable(byte[] bytes, long pixels) {}

    private static byte[] read(Path file) throws IOException {
        return RegularFile.readBytes(file, "an image", JenLimits.TEXTURE_BYTES);
    }

    private Optional<TextureMap> texture(Optional<String> name, TextureUsage usage) {
        if (name.isEmpty()) {
            return Optional.empty();
        }
        UsedImage image = requireNonNull(used.get(name.get()));
        int others = used.values().stream().mapToInt(UsedImage::usageCount).sum();
        if (others >= JenLimits.TEXTURES && !image.usages.contains(usage)) {
            notes.add("textures after the first " + JenLimits.TEXTURES);
            return Optional.empty();
        }
        image.usages.add(usage);
        return SceneAssembler.placeholderTexture(name.get());
    }

    private String use(String name, long pixels, UsedImage.Content content) {
        used.put(name, new UsedImage(pixels, content));
        return name;
    }

    /** Returns an image that a scene can use, converted to PNG if its format is another one; empty if that is not possible. */
    private Optional<Usable> usable(byte[] bytes) {
        byte[] known = bytes;
        if (!SceneAssembler.isPngOrJpeg(bytes)) {
            try {
                known = ImageFile.toPng("image", bytes, CONVERTED, JenLimits.TEXTURE_PIXELS);
            } catch (UnusableFileException e) {
                notes.add("textures of unknown formats, or damaged");
                return Optional.empty();
            }
        }
        byte[] usable = known;
        try {
            // Decoded to see that a scene can use it.
            return Optional.of(ImageFile.read("image", usable, TextureFile.REDUCIBLE, image -> {
                TextureFile.reduced(image, TextureUsage.DATA);
                return new Usable(usable, image.pixelCount());
            }));
        } catch (UnusableFileException e) {
            notes.add("textures that are damaged, or wider than " + JenLimits.TEXTURE_SIDE + " pixels");
            return Optional.empty();
        }
    }

    private static boolean isPng(byte[] bytes) {
        return bytes[1] == 'P';
    }

    /**
     * Reduces the largest images until all fit into a scene.
     *
     * @return new names of reduced images
     */
    UnaryOperator<String> fit() throws IOException {
        long limit = JenLimits.TEXTURE_PIXELS;
        LongToDoubleFunction total =
                max -> used.values().stream().mapToDouble(i -> (double) i.usageCount() * Math.min(i.pixels, max)).sum();
        while (limit > 1 && total.applyAsDouble(limit) > JenLimits.TOTAL_TEXTURE_PIXELS) {
            limit /= 2;
        }
        Map<String, String> renamed = new HashMap<>();
        for (Map.Entry<String, UsedImage> image : used.entrySet()) {
            if (image.getValue().pixels > limit && image.getValue().usageCount() > 0) {
                notes.add("textures reduced to fit into a scene");
                renamed.put(image.getKey(), assembler.replaceFile(image.getKey(), stem(image.getKey()) + ".reduced.png",
                        image.getValue().reduced(limit)));
            }
        }
        return name -> renamed.getOrDefault(name, name);
    }

    private static String stem(String name) {
        return name.replaceFirst("\\.[^./]*$", "");
    }
}
