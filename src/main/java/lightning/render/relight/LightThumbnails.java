package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.cache.SampleBlock;
import lightning.render.cache.TileLevel;
import lightning.render.image.Film;
import lightning.render.shading.ClearMaterialShader;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.RowContribution;
import lightning.render.shading.fog.BounceColumns;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.BounceStart;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Thumbnails of every light's contribution to a picture, composed from its cache. No ray is cast, and only the rows of the
 * thumbnail's pixels are processed, so all lights together take less time than composing one picture. Diffuse indirect light is included
 * if its solution for each light is given.
 *
 * <p>A pixel is represented by its center, or by its first sample if all pixels have several. Each value then has the bits of
 * {@link Renderer#lightImage} of a picture without anti-aliasing. A cache is never modified, so this may run on any thread
 * concurrently with the renderer.
 */
public final class LightThumbnails {
    private final Scene scene;
    private final int width;
    private final int height;
    /** Image of each light, the environment last: red, green, blue of each pixel, the top row first. */
    private final float[][] lightImages;
    private final float[] image;
    private final boolean hasAllLight;

    private LightThumbnails(Scene scene, int width, int height, int lights, boolean hasAllLight) {
        this.hasAllLight = hasAllLight;
        this.scene = scene;
        this.width = width;
        this.height = height;
        lightImages = new float[lights][3 * width * height];
        image = new float[3 * width * height];
    }

    /**
     * Creates thumbnails of direct light with the picture's aspect ratio.
     *
     * @param maxWidth pixels, ≥ 1, with {@code maxHeight}
     * @throws IllegalStateException if mirror levels are stored as hit shapes
     */
    public static LightThumbnails of(PixelCache cache, int maxWidth, int maxHeight) {
        return of(cache, maxWidth, maxHeight, null, Progress.NONE);
    }

    /**
     * Creates thumbnails with the picture's aspect ratio.
     *
     * @param indirect indirect light of the picture by light; null for thumbnails of direct light
     * @throws IllegalStateException if mirror levels are stored as hit shapes
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public static LightThumbnails of(PixelCache cache, int maxWidth, int maxHeight, @Nullable IndirectByLight indirect, Progress progress) {
        int w = cache.scene().picture().width();
        int h = cache.scene().picture().height();
        double shrink = Math.max(1, Math.max((double) w / maxWidth, (double) h / maxHeight));
        return of(cache, pixelPositions(w, (int) Math.max(1, w / shrink)), pixelPositions(h, (int) Math.max(1, h / shrink)), indirect,
                progress);
    }

    /** Creates the thumbnails of one pixel, in column {@code x} from the left and row {@code y} from the top. */
    public static LightThumbnails pixel(PixelCache cache, int x, int y, IndirectByLight indirect, Progress progress) {
        return of(cache, new int[] {x}, new int[] {y}, indirect, progress);
    }

    /** Returns the midpoints of {@code count} equal parts of a side. */
    private static int[] pixelPositions(int side, int count) {
        int[] places = new int[count];
        Arrays.setAll(places, i -> (int) ((2L * i + 1) * side / (2L * count)));
        return places;
    }

    private static LightThumbnails of(PixelCache cache, int[] columns, int[] rows, @Nullable IndirectByLight indirect, Progress progress) {
        WeightedLight[] top = WeightedLight.ofScene(cache.scene());
        var shares = new LightThumbnails(cache.scene(), columns.length, rows.length, top.length,
                indirect != null || cache.indirect() == null && cache.mirrored().indirect() == null);
        Film film = cache.film();
        for (int i = 0; i < shares.image.length / 3; i++) {
            int x = columns[i % columns.length];
            int y = rows[i / columns.length];
            shares.image[3 * i] = film.red(x, y);
            shares.image[3 * i + 1] = film.green(x, y);
            shares.image[3 * i + 2] = film.blue(x, y);
        }
        var levels = new LevelWalk(cache, top);
        short[] target = new short[Film.TILE_PIXELS];
        int tilesPerRow = Film.tilesAlong(cache.scene().picture().width());
        for (int y0 = 0; y0 < rows.length;) {
            int y1 = tileEnd(rows, y0);
            for (int x0 = 0; x0 < columns.length;) {
                int x1 = tileEnd(columns, x0);
                Arrays.fill(target, (short) -1);
                for (int y = y0; y < y1; y++) {
                    for (int x = x0; x < x1; x++) {
                        // The positions of one tile fit into its pixel count.
                        target[Film.pixelInTile(columns[x], rows[y])] = (short) ((y - y0) * (x1 - x0) + x - x0);
                    }
                }
                var part = new TilePart(x0, y0, x1 - x0, columns.length);
                levels.addTile(cache, rows[y0] / Film.TILE_SIZE * tilesPerRow + columns[x0] / Film.TILE_SIZE, target, part);
                x0 = x1;
            }
            y0 = y1;
        }
        for (int l = 0; l < top.length; l++) {
            // The first light of an environment has the indirect light of all of its lights.
            boolean isFirst = l < cache.scene().lights().size() || cache.scene().rig().environmentStartingAt(l) >= 0;
            levels.setIndirect(indirect == null || !isFirst ? IndirectByLight.Solution.NONE
                    : indirect.of(cache, l, progress));
            levels.render(l, shares.lightImages[l]);
        }
        return shares;
    }

    /** Returns the end of the positions in the tile of the one at {@code from}. */
    private static int tileEnd(int[] places, int from) {
        int end = from;
        while (end < places.length && places[end] / Film.TILE_SIZE == places[from] / Film.TILE_SIZE) {
            end++;
        }
        return end;
    }

    /** Position of one tile's pixels among all selected ones. */
    private record TilePart(int left, int top, int width, int across) {
        int index(int i) {
            return (top + i / width) * across + left + i % width;
        }
    }

    /** Selected rows of a tile's pixels. */
    private record SelectedPart(TilePart part, SelectedRows rows, @Nullable FogTile fog, short[] target) {}

    /** Rows of single pixels and of everything seen from there in mirrors and through clear surfaces. */
    private static final class LevelWalk {
        private final WeightedLight[] lights;
        /** Lights that the mirrors show, each at the index of the light with its name; null if there is none. */
        private final WeightedLight[] mirrorLights;
        /** Layer index of each of these lights in a mirror level. */
        private final int[] mirrorLayer;
        private final RowContribution eyeShader;
        private final RowContribution mirrorShader;
        private final Fog fog;
        /** Fog of the mirrored scene, and all its lights. */
        private final Fog mirrorFog;
        private final WeightedLight[] allMirrorLights;
        private final @Nullable BounceFog bounceFog;
        private final MaterialTable mirrorMaterials;
        private final int depth;
        private final int tilesAcross;
        private final List<SelectedPart> parts = new ArrayList<>();
        private IndirectByLight.Solution indirect = IndirectByLight.Solution.NONE;
        private TileLevel[] levels = {};
        /** Next level of the walk. */
        private int nextLevel;

        LevelWalk(PixelCache cache, WeightedLight[] top) {
            this.lights = top;
            depth = cache.scene().picture().depth();
            tilesAcross = Film.tilesAlong(cache.scene().picture().width());
            mirrorLights = new WeightedLight[top.length];
            mirrorLayer = new int[top.length];
            WeightedLight[] known = WeightedLight.ofScene(cache.mirrored().scene());
            for (int l = 0; l < top.length; l++) {
                for (int m = 0; m < known.length; m++) {
                    if (known[m].light().name().equals(top[l].light().name())) {
                        mirrorLights[l] = known[m];
                        mirrorLayer[l] = m;
                    }
                }
            }
            fog = cache.scene().world().fog();
            bounceFog = BounceFog.of(cache.mirrored().scene(), cache.mirrored().fog());
            mirrorFog = cache.mirrored().scene().world().fog();
            allMirrorLights = known;
            mirrorMaterials = cache.mirroredGeometry().materials();
            eyeShader = new RowContribution(cache.geometry().materials());
            mirrorShader = new RowContribution(cache.mirroredGeometry().materials());
        }

        void addTile(PixelCache cache, int index, short[] target, TilePart part) {
            SamplePositions centers = SamplePositions.centers(index % tilesAcross * Film.TILE_SIZE, index / tilesAcross * Film.TILE_SIZE);
            if (cache.tileCount() > 0) {
                addRows(cache.tile(index), centers, target, part);
                return;
            }
            FineSamples all = cache.fineTile(index).first();
            for (SampleBlock block : all.blocks()) {
                short[] first = new short[Film.TILE_PIXELS];
                Arrays.fill(first, (short) -1);
                for (int i = 0; i < block.pixels().length; i++) {
                    first[i * all.cells().count()] = target[block.pixels()[i]];
                }
                addRows(block.rows(), new SamplePositions(centers.x0(), centers.y0(), block.pixels(), all.cells()), first, part);
            }
        }

        /** @param target for each position of the tile its index in the part, or −1 */
        private void addRows(CachedTile tile, SamplePositions places, short[] target, TilePart part) {
            if (!tile.storesRows()) {
                throw new IllegalStateException("mirror levels are stored as hit shapes");
            }
            levels = tile.levels;
            nextLevel = 1;
            parts.add(new SelectedPart(part, collectLevel(0, bounceFog == null ? null : bounceFog.start(places, tile.rows()), 0, target),
                    tile.fog, tile.fog == null ? target : target.clone()));
        }

        /** Sets the indirect light that is added from now on. */
        void setIndirect(IndirectByLight.Solution v) {
            indirect = v;
        }

        /** Writes one light's contribution to all pixels. */
        void render(int light, float[] to) {
            for (SelectedPart selected : parts) {
                SelectedRows first = selected.rows;
                float[] colors = first.colors(eyeShader, lights[light], light, this);
                for (int i = 0; i < first.count; i++) {
                    System.arraycopy(colors, 3 * i, to, 3 * selected.part.index(first.parentNumber[i]), 3);
                }
                if (selected.fog != null) {
                    for (int i = 0; i < selected.target.length; i++) {
                        if (selected.target[i] >= 0) {
                            FogComposer.addLight(selected.fog, i, lights, light, fog, to,
                                    3 * selected.part.index(selected.target[i]));
                        }
                    }
                }
            }
        }

        /**
         * Collects a level and all levels seen from it, in the order of {@code relight.tile.BounceLevels}.
         *
         * @param start the level's rows as the start of bounced rays; null if these show no light in fog
         */
        private SelectedRows collectLevel(int at, @Nullable BounceStart start, int level, short[] above) {
            SelectedRows selected = new SelectedRows(levels[at], above);
            short[] numbers = selected.numbers();
            for (BounceKind bounce : BounceKind.values()) {
                if (level < depth && bounce.rowCount(levels[at].rows()) > 0) {
                    int below = nextLevel++;
                    HitRows seen = levels[below].rows();
                    selected.bounces[bounce.ordinal()] =
                            collectLevel(below, start == null ? null : start.below(bounce, seen), level + 1, numbers);
                    if (bounceFog != null) {
                        float[] passed = new float[Film.TILE_PIXELS];
                        bounceFog.writeTransmittances(levels[at].rows(), seen, bounce, mirrorMaterials, passed);
                        selected.transmittances[bounce.ordinal()] = passed;
                        selected.columns[bounce.ordinal()] = bounceFog.columns(levels[at].rows(), seen, bounce, mirrorMaterials, start,
                                allMirrorLights, levels[below].fog());
                    }
                }
            }
            return selected;
        }
    }

    /** Selected rows of a level and the levels seen from them. */
    private static final class SelectedRows {
        private final TileLevel level;
        /** Levels seen from these rows, by {@link BounceKind}; null if no ray bounces. */
        private final SelectedRows[] bounces = new SelectedRows[BounceKind.values().length];
        /** Transmittance of the fog along the rays from all rows of the level, by {@link BounceKind}; null in clear air. */
        private final float[] @Nullable [] transmittances = new float[BounceKind.values().length][];
        /** Light in this fog, by {@link BounceKind}; null if none is seen. */
        private final @Nullable BounceColumns[] columns = new BounceColumns[BounceKind.values().length];
        private final int[] row;
        private final int[] material;
        /** Number of each row's parent. */
        private final short[] parentNumber;
        private int count;

        /** @param numbers numbers of the rows or pixels that the level is seen from; −1 if not selected */
        SelectedRows(TileLevel level, short[] numbers) {
            this.level = level;
            HitRows rows = level.rows();
            int max = 0;
            for (int i = 0; i < rows.count; i++) {
                max += numbers[rows.parent[i]] >= 0 ? 1 : 0;
            }
            row = new int[max];
            material = new int[max];
            parentNumber = new short[max];
            for (int r = 0; r < rows.runCount; r++) {
                for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                    if (numbers[rows.parent[i]] >= 0) {
                        row[count] = i;
                        material[count] = rows.runMaterial[r];
                        parentNumber[count++] = numbers[rows.parent[i]];
                    }
                }
            }
        }

        /** Returns for each row of the level its number here, −1 if it is not selected. */
        short[] numbers() {
            short[] numbers = new short[level.rows().count];
            Arrays.fill(numbers, (short) -1);
            for (int i = 0; i < count; i++) {
                numbers[row[i]] = (short) i;
            }
            return numbers;
        }

        /** Returns a light's contribution to the color of each row: red, green, blue. */
        float[] colors(RowContribution equation, WeightedLight light, int layer, LevelWalk levels) {
            float[] mirrored = bounceColors(BounceKind.MIRRORED, layer, levels);
            float[] refracted = bounceColors(BounceKind.REFRACTED, layer, levels);
            float[] colors = new float[3 * count];
            LightLayer rows = level.layers()[equation == levels.eyeShader ? layer : levels.mirrorLayer[layer]];
            float[][] indirect = equation == levels.eyeShader ? levels.indirect.shown() : levels.indirect.mirrored();
            float[] indirectRow = indirect == null ? null : new float[indirect.length];
            for (int i = 0; i < count; i++) {
                if (indirect != null && indirectRow != null) {
                    requireNonNull(level.weights()).interpolate(indirect, row[i], indirectRow);
                }
                equation.color(level.rows(), row[i], material[i], light, rows, indirectRow, mirrored, refracted, 3 * i, colors, 3 * i);
            }
            return colors;
        }

        /** Returns the colors of one kind of bounce from each row; 0 if no ray bounces. */
        private float[] bounceColors(BounceKind bounce, int layer, LevelWalk levels) {
            float[] images = new float[3 * count];
            SelectedRows selected = bounces[bounce.ordinal()];
            if (selected != null && levels.mirrorLights[layer] != null) {
                float[] colors = selected.colors(levels.mirrorShader, levels.mirrorLights[layer], layer, levels);
                for (int i = 0; i < selected.count; i++) {
                    System.arraycopy(colors, 3 * i, images, 3 * selected.parentNumber[i], 3);
                }
            }
            float[] passed = transmittances[bounce.ordinal()];
            for (int i = 0; passed != null && i < images.length; i++) {
                images[i] *= passed[row[i / 3]];
            }
            BounceColumns fog = columns[bounce.ordinal()];
            if (fog != null && levels.mirrorLights[layer] != null && !levels.mirrorLights[layer].isDarkInFog()) {
                addScattered(fog.columns()[levels.mirrorLayer[layer]], levels.mirrorLights[layer], levels.mirrorFog, images);
            }
            return images;
        }

        private void addScattered(float @Nullable [] column, WeightedLight light, Fog fog, float[] images) {
            for (int i = 0; column != null && i < images.length; i++) {
                // Only the first rows cast rays.
                float seen = row[i / 3] < column.length ? column[row[i / 3]] : 0;
                images[i] += ClearMaterialShader.channel(fog.color(), i % 3) * (light.fog().channel(i % 3) * seen);
            }
        }
    }

    /** Returns the scene that the picture shows. */
    public Scene scene() {
        return scene;
    }

    /** Returns the width in pixels. */
    public int width() {
        return width;
    }

    /** Returns the height in pixels. */
    public int height() {
        return height;
    }

    /** Returns the picture at these pixels: red, green, blue of each, linear, the top row first. */
    public float[] image() {
        return image.clone();
    }

    /** Returns whether contributions include the indirect light of the picture, or it has none. */
    public boolean hasAllLight() {
        return hasAllLight;
    }

    /** Returns the contribution of the scene's light at an index, in the layout of {@link #image}. */
    public float[] lightImage(int nodeIndex) {
        return lightImages[nodeIndex].clone();
    }

    /** Returns the summed contributions of several lights, in the layout of {@link #image}. */
    public float[] sumOfLights(int... places) {
        float[] sum = new float[image.length];
        for (int nodeIndex : places) {
            add(lightImages[nodeIndex], sum);
        }
        return sum;
    }

    private static void add(float[] values, float[] to) {
        for (int i = 0; i < to.length; i++) {
            to[i] += values[i];
        }
    }

    /** Returns the mean luminance, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). */
    public static double brightness(float[] rgb) {
        double sum = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            sum += 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
        }
        return 3 * sum / rgb.length;
    }
}
