package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import lightning.base.file.UnusableFileException;
import lightning.base.math.Affine2;
import lightning.format.exchange.assembly.PlacedTexture;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TextureAtlas;
import lightning.format.exchange.assembly.TextureMeans;
import lightning.format.gltf.JsonValue;
import lightning.format.image.ImageSource;
import lightning.format.jen.asset.JenLimits;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.asset.TextureWrap;

/**
 * Image files of a stage. PNG and JPEG files are copied; OpenEXR files, images that are too large and tiles of one texture (UDIM) are
 * written as PNG.
 */
final class UsdTextures {
    private final SceneAssembler assembler;
    private final Map<String, Optional<String>> names = new HashMap<>();
    private final Map<Path, Long> sizes = new HashMap<>();
    private long maxPixels = JenLimits.TEXTURE_PIXELS;

    UsdTextures(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /** Chooses the largest size at which all textures fit into a scene; larger ones are reduced. */
    void fit(List<JsonValue> images) throws IOException, MeshException {
        Map<String, Long> pixels = new HashMap<>();
        for (JsonValue image : images) {
            Optional<UsdTiles> tiles = tiles(image);
            if (tiles.isPresent()) {
                long largest = 0;
                for (UsdTiles.Tile tile : tiles.get().tiles()) {
                    largest = Math.max(largest, size(tile.place()));
                }
                pixels.put(tiles.get().key(), largest * tiles.get().columns() * tiles.get().rows());
            }
        }
        LongToDoubleFunction total = limit -> pixels.values().stream().mapToDouble(v -> Math.min(v, limit)).sum();
        while (maxPixels > 1 && total.applyAsDouble(maxPixels) > JenLimits.TOTAL_TEXTURE_PIXELS) {
            maxPixels /= 2;
        }
    }

    private long size(Path place) throws IOException {
        if (!sizes.containsKey(place)) {
            try {
                sizes.put(place, UsdImages.read(place, ImageSource::pixelCount));
            } catch (UnusableFileException e) {
                sizes.put(place, 0L);
            }
        }
        return sizes.get(place);
    }

    /** Returns the image files of a texture that exist; empty if there are none. */
    private Optional<UsdTiles> tiles(JsonValue image) throws MeshException {
        return image.isPresent() ? UsdTiles.of(image) : Optional.empty();
    }

    /** Returns a texture; empty if absent, missing or of another format. */
    Optional<TextureMap> map(JsonValue image, TextureUsage usage) throws IOException, MeshException {
        return map(image, usage.toString(), (tiles, name) -> copied(tiles, name, usage));
    }

    /**
     * Returns a gray texture of 16 bits that has the numbers of another one; empty as {@link #map}.
     *
     * @param input what the numbers are, part of the name of the new file
     */
    Optional<TextureMap> numbers(JsonValue image, TextureNumbers numbers, String input) throws IOException, MeshException {
        return map(image, numbers.toString(),
                (tiles, name) -> converted(tiles, withSuffix(name, "-" + input), TextureUsage.DATA, numbers::read, true));
    }

    /**
     * Returns a texture of opacity: the image itself if its alpha, or the gray of one without alpha, are the numbers, else a gray one of 16 bits;
     * empty as {@link #map}.
     */
    Optional<TextureMap> opacity(JsonValue image, TextureNumbers numbers) throws IOException, MeshException {
        return map(image, "opacity " + numbers, (tiles, name) -> isOwnOpacity(tiles, numbers) ? copied(tiles, name, TextureUsage.OPACITY)
                : converted(tiles, withSuffix(name, "-opacity"), TextureUsage.DATA, numbers::read, true));
    }

    private static boolean isOwnOpacity(UsdTiles tiles, TextureNumbers numbers) throws IOException {
        for (UsdTiles.Tile tile : tiles.tiles()) {
            if (!numbers.isOpacityOf(tile)) {
                return false;
            }
        }
        return true;
    }

    /** Returns whether numbers of a texture are the alpha of an image that has none, unchanged: 1 everywhere. */
    boolean isOpaque(JsonValue image, TextureNumbers numbers) throws IOException, MeshException {
        Optional<UsdTiles> tiles = tiles(image);
        try {
            return tiles.isPresent() && numbers.isAlpha() && numbers.of(1) == 1
                    && !UsdImages.read(tiles.get().tiles().getFirst().place(), ImageSource::hasAlpha);
        } catch (UnusableFileException e) {
            return false;
        }
    }

    private static String withSuffix(String name, String suffix) {
        return name.replaceFirst("(\\.[^.]*)?$", suffix + ".png");
    }

    /** Writer of the image of a texture: returns its name in the scene. */
    @FunctionalInterface
    private interface TileWriter {
        String write(UsdTiles tiles, String name) throws IOException;
    }

    private Optional<TextureMap> map(JsonValue image, String kind, TileWriter writer) throws IOException, MeshException {
        Optional<UsdTiles> tiles = tiles(image);
        assembler.notes.add("textures that are missing", image.isPresent() && tiles.isEmpty() ? 1 : 0);
        if (tiles.isEmpty()) {
            return Optional.empty();
        }
        UsdTiles all = tiles.get();
        String key = kind + " " + all.key();
        if (!names.containsKey(key)) {
            names.put(key, write(all, image.get("name").text().orElse("texture"), writer));
        }
        TextureWrap wrap = all.isSingle() ? wrap(image.get("wrap")) : TextureWrap.REPEAT;
        double[] p = Arrays.stream(image.get("placement").numbers(1, 0, 0, 0, 1, 0)).map(UsdNumbers::tidy).toArray();
        var map = new Affine2(1.0 / all.columns(), 0, 0, 0, 1.0 / all.rows(), 0).times(new Affine2(p[0], p[1], p[2], p[3], p[4], p[5]));
        return names.get(key).map(file -> placed(new TextureMap(file, 1.0 / all.columns(), 1.0 / all.rows(),
                new Texture(1, 1, new float[3]), wrap), map));
    }

    private TextureMap placed(TextureMap texture, Affine2 map) {
        Optional<TextureMap> placed = PlacedTexture.of(texture, map);
        assembler.notes.add("textures that are sheared, or scaled to nothing, imported without their placement", placed.isEmpty() ? 1 : 0);
        return placed.orElse(texture);
    }

    /** Returns what follows the edges of a texture; those of several tiles repeat together. */
    private static TextureWrap wrap(JsonValue axes) throws MeshException {
        return axes.isPresent() ? new TextureWrap(edge(axes.element(0)), edge(axes.element(1))) : TextureWrap.REPEAT;
    }

    private static TextureWrap.Edge edge(JsonValue axis) throws MeshException {
        return switch (axis.text().orElse("")) {
            case "clamp" -> TextureWrap.Edge.CLAMP;
            case "mirror" -> TextureWrap.Edge.MIRROR;
            default -> TextureWrap.Edge.REPEAT;
        };
    }

    private Optional<String> write(UsdTiles tiles, String name, TileWriter writer) throws IOException {
        if (names.values().stream().filter(Optional::isPresent).count() >= JenLimits.TEXTURES) {
            assembler.notes.add("textures after the first " + JenLimits.TEXTURES);
            return Optional.empty();
        }
        try {
            UsdImages.read(tiles.tiles().getFirst().place(), ImageSource::pixelCount);
            return Optional.of(writer.write(tiles, name));
        } catch (UnusableFileException e) {
            assembler.notes.add("textures that are not PNG, JPEG or OpenEXR, or have more than 64 MiB");
            return Optional.empty();
        }
    }

    private String copied(UsdTiles tiles, String name, TextureUsage usage) throws IOException {
        Path first = tiles.tiles().getFirst().place();
        return tiles.isSingle() && !UsdImages.isExr(first) && size(first) <= maxPixels ? assembler.addFile(first, name)
                : converted(tiles, name, usage, tile -> UsdImages.read(tile.place(), usage), UsdImages.isExr(first));
    }

    /** Reader of the image of a tile. */
    @FunctionalInterface
    private interface TileReader {
        Texture read(UsdTiles.Tile tile) throws IOException;
    }

    /** Writes tiles as one PNG file and returns its name; one of 16 bits that is too large has 8. */
    private String converted(UsdTiles tiles, String name, TextureUsage usage, TileReader reader, boolean isDeep)
            throws IOException {
        Texture first = reader.read(tiles.tiles().getFirst());
        int step = ImageSource.step(first.width(), first.height(), Math.max(1, maxPixels / ((long) tiles.columns() * tiles.rows())));
        while (Math.max(Math.ceilDiv(first.width(), step) * tiles.columns(),
                Math.ceilDiv(first.height(), step) * tiles.rows()) > JenLimits.TEXTURE_SIDE) {
            step++;
        }
        assembler.notes.add("textures reduced to fit into a scene",
                step > 1 || sizes.getOrDefault(tiles.tiles().getFirst().place(), 0L) > maxPixels ? 1 : 0);
        byte[] png = atlas(tiles, usage, first, reader, step, isDeep);
        return assembler.addFile(name.replaceFirst("\\.[^.]*$", "").replace("<UDIM>", "tiles") + ".png",
                png.length > JenLimits.TEXTURE_BYTES && isDeep ? atlas(tiles, usage, first, reader, step, false) : png);
    }

    private byte[] atlas(UsdTiles tiles, TextureUsage usage, Texture first, TileReader reader, int step, boolean isDeep)
            throws IOException {
        var atlas = new TextureAtlas(tiles.columns(), tiles.rows(), Math.ceilDiv(first.width(), step), Math.ceilDiv(first.height(), step),
                usage, isDeep);
        for (UsdTiles.Tile tile : tiles.tiles()) {
            boolean isFirst = tile == tiles.tiles().getFirst();
            atlas.draw(isFirst ? first : reader.read(tile), tile.column(), tile.row());
        }
        assembler.notes.add("values of OpenEXR textures above 1, limited to 1", atlas.isClamped() ? 1 : 0);
        return atlas.png();
    }

    /** Returns whether the values of a texture may exceed 1. */
    boolean hasHighRange(JsonValue image) throws MeshException {
        return tiles(image).stream().flatMap(tiles -> tiles.tiles().stream()).anyMatch(tile -> UsdImages.isExr(tile.place()));
    }

    /** Returns the mean of each channel of a texture, in linear light; empty if it is missing or of another format. */
    Optional<double[]> mean(JsonValue image, TextureUsage usage) throws IOException, MeshException {
        return mean(image, tile -> UsdImages.read(tile.place(), usage));
    }

    /** Returns the mean of numbers of a texture; empty as above. */
    Optional<Double> mean(JsonValue image, TextureNumbers numbers) throws IOException, MeshException {
        return mean(image, numbers::read).map(mean -> mean[0]);
    }

    private Optional<double[]> mean(JsonValue image, TileReader reader) throws IOException, MeshException {
        Optional<UsdTiles> tiles = tiles(image);
        if (tiles.isEmpty()) {
            return Optional.empty();
        }
        double[] sums = new double[3];
        try {
            for (UsdTiles.Tile tile : tiles.get().tiles()) {
                Texture texture = reader.read(tile);
                for (int c = 0; c < 3; c++) {
                    sums[c] += TextureMeans.mean(texture, c) / tiles.get().tiles().size();
                }
            }
            return Optional.of(sums);
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }
}
