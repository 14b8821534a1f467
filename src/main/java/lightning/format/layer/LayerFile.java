package lightning.format.layer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.SafeFile;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWriter;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Crew;
import lightning.render.engine.EngineChoice;
import lightning.render.image.Film;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;
import tools.jackson.databind.json.JsonMapper;

/**
 * Writes a picture with its layers as one file of OpenEXR, a row of tiles at a time. The picture itself is the channels R, G and B. All
 * other colours add up to it, as {@link Addition} tells; the header tells in which order, and what the numbers of shapes and materials are.
 */
public final class LayerFile {
    private static final List<String> COLORS = List.of("R", "G", "B");
    private static final String ROUNDING = "rounding";
    /** Of the bytes of a row of tiles: as they are, their bytes apart, packed, and packed as they wait. */
    private static final int COPIES = 4;

    private final PixelCache cache;
    private final EngineChoice engines;
    private final Scene scene;
    private final Film film;
    private final boolean whole;
    private final List<Layer> layers;
    private final ExrHeader header;
    /** The places in the header of red, green and blue of the picture, of each layer and of what is missing. */
    private final int[][] colors;
    private final int[] data;

    /**
     * @param cache what is known of a finished picture
     * @param type  of colours and normals, HALF or FLOAT; all else is FLOAT. In a file of halves there is no layer of what floats round
     */
    public LayerFile(PixelCache cache, EngineChoice engines, ExrType type) {
        this.cache = cache;
        this.engines = engines;
        scene = cache.scene();
        film = cache.film();
        whole = type == ExrType.FLOAT;
        layers = Layer.of(scene);
        List<String> names = new ArrayList<>(List.of(""));
        LayerNames.of(layers).forEach(name -> names.add(name + "."));
        if (whole) {
            names.add(ROUNDING + ".");
        }
        List<ExrChannel> channels = new ArrayList<>();
        names.forEach(name -> COLORS.forEach(color -> channels.add(new ExrChannel(name + color, type))));
        Surfaces.CHANNELS.forEach(name -> channels.add(new ExrChannel(name, name.startsWith("N.") ? type : ExrType.FLOAT)));
        header = new ExrHeader(film.width(), film.height(), channels, texts());
        List<String> places = header.channels().stream().map(ExrChannel::name).toList();
        colors = names.stream().map(name -> COLORS.stream().mapToInt(color -> places.indexOf(name + color)).toArray())
                .toArray(int[][]::new);
        data = Surfaces.CHANNELS.stream().mapToInt(places::indexOf).toArray();
    }

    private Map<String, String> texts() {
        List<String> names = LayerNames.of(layers);
        List<String> sum = new ArrayList<>(names);
        if (whole) {
            sum.add(ROUNDING);
        }
        Map<String, String> lights = new LinkedHashMap<>();
        for (int i = 0; i < names.size(); i++) {
            if (layers.get(i) instanceof Layer.Lights light) {
                lights.put(names.get(i), light.name());
            }
        }
        JsonMapper json = new JsonMapper();
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put("software", "Lightning");
        texts.put("lightning/sum", json.writeValueAsString(sum));
        texts.put("lightning/lights", json.writeValueAsString(lights));
        texts.put("lightning/shapes", json.writeValueAsString(scene.stage().shapes().stream().map(Shape::name).toList()));
        texts.put("lightning/materials", json.writeValueAsString(materials()));
        return texts;
    }

    private List<String> materials() {
        List<String> names = new ArrayList<>();
        for (int m = 0; m < cache.geometry().materials().count(); m++) {
            Material material = cache.geometry().materials().material(m);
            names.add(material.name());
        }
        return names;
    }

    /** How many layers of colours there are, the picture itself left out. */
    public int layerCount() {
        return colors.length - 1;
    }

    /** The bytes that writing takes beside what is known of the picture. */
    public long bytesToWrite(int threads) {
        return (long) COPIES * threads * header.bytesPerLine() * Film.TILE;
    }

    /**
     * Writes it; the file holds the whole new picture or what it held before, at every moment.
     *
     * @param memory bytes that this may take
     * @throws IOException                                if it cannot be written, or would take more memory; the message is a sentence
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public void write(Path file, long memory, Workers workers, Progress progress) throws IOException {
        if (bytesToWrite(workers.count()) > memory || header.bytesPerLine() * ExrHeader.LINES > Integer.MAX_VALUE / 2) {
            throw new IOException(String.format(java.util.Locale.ROOT,
                    "%d layers of %d x %d pixels take %.1f GB of memory to write, and may take %.1f GB", colors.length, film.width(),
                    film.height(), bytesToWrite(workers.count()) / 1e9, Math.max(memory, 0) / 1e9));
        }
        try {
            SafeFile.at(file).writeAnywhere(channel -> {
                ExrWriter writer = new ExrWriter(channel, header);
                List<Crew<LayerPainter>> painters = Crew.each(workers.count(), engines, engine -> new LayerPainter(cache, engine));
                workers.run(Math.ceilDiv(film.height(), Film.TILE), (worker, row) -> row(painters.get(worker), row, writer), progress);
                writer.finish();
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Writes a row of tiles, two chunks. */
    private void row(Crew<LayerPainter> painters, int row, ExrWriter writer) {
        ExrChunk[] chunks = new ExrChunk[Math.min(Film.TILE / ExrHeader.LINES, header.chunks() - row * Film.TILE / ExrHeader.LINES)];
        for (int c = 0; c < chunks.length; c++) {
            chunks[c] = new ExrChunk(header, row * Film.TILE / ExrHeader.LINES + c);
        }
        for (int column = 0; column < film.tilesX(); column++) {
            int tile = row * film.tilesX() + column;
            tile(painters.forTile(tile), tile, SamplePlaces.centers(column * Film.TILE, row * Film.TILE), chunks);
        }
        try {
            for (int c = 0; c < chunks.length; c++) {
                byte[] packed = chunks[c].packed();
                chunks[c] = null;
                writer.put(row * Film.TILE / ExrHeader.LINES + c, packed);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void tile(LayerPainter painter, int tile, SamplePlaces places, ExrChunk[] chunks) {
        float[][] picture = {film.red(tile), film.green(tile), film.blue(tile)};
        put(picture, colors[0], places, chunks);
        Addition addition = new Addition(Film.TILE_PIXELS);
        for (int k = 0; k < layers.size(); k++) {
            float[][] layer = pixels(painter, layers.get(k), tile, places);
            addition.add(layer);
            put(layer, colors[k + 1], places, chunks);
        }
        if (whole) {
            put(addition.rounding(picture), colors[layers.size() + 1], places, chunks);
        }
        Surfaces surfaces = new Surfaces(cache);
        float[] values = new float[data.length];
        each(places, (x, y, pixel) -> {
            surfaces.at(x, y, values);
            for (int i = 0; i < data.length; i++) {
                chunk(chunks, y).put(data[i], x, y % ExrHeader.LINES, values[i]);
            }
        });
    }

    /** A tile of a layer, the means of its samples where it has them. */
    private float[][] pixels(LayerPainter painter, Layer layer, int tile, SamplePlaces places) {
        CachedTile center = cache.tileCount() == 0 ? null : colored(painter, layer, cache.tile(tile), places);
        return cache.fineCount() == 0 ? center.film : cache.fine(tile)
                .map(center, places, (at, block) -> colored(painter, layer, block, at), scene.picture().sampling().grid()).film();
    }

    private static CachedTile colored(LayerPainter painter, Layer layer, CachedTile tile, SamplePlaces places) {
        return new CachedTile(tile.levels, tile.hitShapes, tile.images, painter.colors(layer, tile, places), tile.codes);
    }

    private void put(float[][] values, int[] channels, SamplePlaces places, ExrChunk[] chunks) {
        each(places, (x, y, pixel) -> {
            for (int c = 0; c < 3; c++) {
                chunk(chunks, y).put(channels[c], x, y % ExrHeader.LINES, values[c][pixel]);
            }
        });
    }

    private static ExrChunk chunk(ExrChunk[] chunks, int y) {
        return chunks[y % Film.TILE / ExrHeader.LINES];
    }

    private interface Place {
        void at(int x, int y, int pixel);
    }

    private void each(SamplePlaces places, Place to) {
        int right = Math.min(places.x0() + Film.TILE, film.width());
        int bottom = Math.min(places.y0() + Film.TILE, film.height());
        for (int y = places.y0(); y < bottom; y++) {
            for (int x = places.x0(); x < right; x++) {
                to.at(x, y, Film.pixelInTile(x, y));
            }
        }
    }
}
