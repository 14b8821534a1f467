package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.TileComposer;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.BounceStart;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Composes tiles from cached layers, independently of earlier compositions. Casts no ray and computes no term. Holds scratch
 * memory: use one instance per thread.
 */
public final class TileRecomposer {
    private final TileComposer eye;
    private final TileComposer mirror;
    private final int depth;
    /** Light of gather points that is added to the first level and to the others. */
    private float @Nullable [][] eyeIndirect;
    private float @Nullable [][] mirrorIndirect;
    private final MaterialTable mirrored;
    /** Fog of bounced rays. */
    private @Nullable BounceFog mirrorFog;
    /** Index of the next level to compose. */
    private int nextLevel;

    public TileRecomposer(PixelCache cache, Engine engine, ViewEffects view) {
        this(cache.scene(), cache.geometry().materials(), cache.mirroredGeometry().materials(), cache.scene().picture().depth(), engine,
                view);
    }

    /**
     * @param scene     scene whose camera and size tell how fine the environment is seen
     * @param materials materials of the first level
     * @param mirrored  materials of the other levels
     * @param depth     maximum recursion depth
     */
    public TileRecomposer(Scene scene, MaterialTable materials, MaterialTable mirrored, int depth, Engine engine, ViewEffects view) {
        this.depth = depth;
        eye = new TileComposer(scene, materials, engine.sums(), view);
        mirror = new TileComposer(scene, mirrored, engine.sums(), view);
        this.mirrored = mirrored;
    }

    /** Sets whether surfaces glow from now on, in mirrors too; initially they do. */
    public void setShowsGlow(boolean v) {
        eye.setShowsGlow(v);
        mirror.setShowsGlow(v);
    }

    /**
     * Sets the indirect light that is added from now on: red, green and blue of the gather points of which all levels have weights; null
     * for none.
     */
    public void setIndirect(float @Nullable [][] direct, float @Nullable [][] mirrored) {
        eyeIndirect = direct;
        mirrorIndirect = mirrored;
    }

    /** Sets the fog that bounced rays pass from now on; initially the air is clear. */
    public void setMirrorFog(@Nullable BounceFog fog) {
        mirrorFog = fog;
    }

    private static @Nullable IndirectRows indirect(TileLevel level, float @Nullable [][] light) {
        return light == null ? null : new IndirectRows(requireNonNull(level.weights()), light);
    }

    /**
     * Composes the colors of the rays that bounce from the first level's rows. Returns scratch memory, valid until the next call;
     * null if there are none.
     *
     * @param places image positions of the first level's rays
     * @param levels all levels; {@code lights} light those from the second on
     */
    public @Nullable BounceImages composeImages(SamplePositions places, TileLevel[] levels, WeightedLight[] lights, World world) {
        nextLevel = 1;
        return composeImages(levels, 0, mirrorFog == null ? null : mirrorFog.start(places, levels[0].rows()), 0, lights, world);
    }

    /** @param start the level's rows as the start of bounced rays; null if these show no light in fog */
    private @Nullable BounceImages composeImages(TileLevel[] levels, int index, @Nullable BounceStart start, int level,
            WeightedLight[] lights, World world) {
        HitRows rows = levels[index].rows();
        if (level == depth || rows.reflectiveCount == 0) {
            return mirror.blackImages(rows);
        }
        BounceImages images = mirror.backgroundImages(rows, world, level);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0) {
                int at = nextLevel++;
                HitRows seen = levels[at].rows();
                BounceImages below =
                        composeImages(levels, at, start == null ? null : start.below(bounce, seen), level + 1, lights, world);
                mirror.composeLevel(seen, lights, levels[at].layers(), world, indirect(levels[at], mirrorIndirect), below,
                        requireNonNull(images).forBounce(bounce));
                if (mirrorFog != null) {
                    mirrorFog.add(rows, seen, bounce, mirrored,
                            mirrorFog.columns(rows, seen, bounce, mirrored, start, lights, levels[at].fog()), lights,
                            images.forBounce(bounce));
                }
            }
        }
        return images;
    }

    /** Composes the tile of the film: red, green, blue, {@code float[1024]} each. */
    public float[][] composeFilm(TileLevel top, WeightedLight[] lights, Scene scene, SamplePositions places,
            @Nullable BounceImages images) {
        float[][] pixels = new float[3][Film.TILE_PIXELS];
        eye.fillBackground(top.rows(), scene, places, pixels);
        eye.composeLevel(top.rows(), lights, top.layers(), scene.world(), indirect(top, eyeIndirect), images, pixels);
        return pixels;
    }
}
