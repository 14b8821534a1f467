package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.BitSet;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.cache.CachedScene;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.shading.BounceImages;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.FilmMixer;
import lightning.render.shading.composition.LightComponent;
import lightning.render.shading.composition.TileComposer;
import lightning.render.shading.fog.BounceColumns;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.BounceStart;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Composes films of tiles from cached layers, independently of earlier compositions. Casts no ray and computes no term. Holds scratch
 * memory: use one instance per thread.
 */
public final class TileRecomposer {
    private final Side eye;
    private final Side mirror;
    private final FilmMixer mixer;
    private final FogComposer fogComposer = new FogComposer();
    /** Fog of bounced rays. */
    private @Nullable BounceFog mirrorFog;
    /** Index of the next level to compose. */
    private int nextLevel;
    private long rowsComposed;
    private long bytesRead;

    /** Composer of the first level, or of the others. */
    private static final class Side {
        private final FilmParts parts;
        private final MaterialTable materials;
        private final TileComposer composer;
        private final float @Nullable [] @Nullable [][] indirect;

        Side(FilmParts parts, MaterialTable materials, float @Nullable [] @Nullable [][] indirect, Engine engine, ViewEffects view) {
            this.parts = parts;
            this.materials = materials;
            this.indirect = indirect;
            composer = new TileComposer(parts.scene(), materials, engine.sums(), view);
        }

        private @Nullable IndirectRows indirect(TileLevel level) {
            return indirect == null ? null : new IndirectRows(requireNonNull(level.weights()), indirect);
        }
    }

    /**
     * Scene of the levels to compose.
     *
     * @param indirect light of each film at the gather points of which all levels have weights; null for none
     */
    public record Shown(FilmParts parts, MaterialTable materials, float @Nullable [] @Nullable [][] indirect) {
        // An array in a record: written once by its creator, never after.

        private static Shown of(CachedScene cached, FilmParts parts, Geometry geometry) {
            IndirectCache indirect = cached.indirect();
            return new Shown(parts, geometry.materials(), indirect == null ? null : indirect.light().light());
        }
    }

    /**
     * @param shown    scene of the first level
     * @param mirrored scene of the other levels: the same object if mirrors are current
     * @param faded    film whose weight alone is being edited; −1 if there is none
     */
    public TileRecomposer(Shown shown, Shown mirrored, Engine engine, ViewEffects view, int faded) {
        eye = new Side(shown.parts, shown.materials, shown.indirect, engine, view);
        mirror = shown == mirrored ? eye : new Side(mirrored.parts, mirrored.materials, mirrored.indirect, engine, view);
        mixer = new FilmMixer(shown.parts, shown == mirrored ? null : mirrored.parts, faded);
    }

    /** Creates what composes a cached picture. */
    public static TileRecomposer of(PixelCache cache, Engine engine, ViewEffects view) {
        Shown shown = Shown.of(cache.shown(), cache.parts(), cache.geometry());
        Shown mirrored = cache.areMirrorsOutdated() ? Shown.of(cache.mirrored(), cache.mirroredParts(), cache.mirroredGeometry()) : shown;
        TileRecomposer recomposer = new TileRecomposer(shown, mirrored, engine, view, -1);
        recomposer.setMirrorFog(BounceFog.of(cache.mirrored().scene(), cache.mirrored().fog()));
        return recomposer;
    }

    /** Sets the fog that bounced rays pass from now on; initially the air is clear. */
    public void setMirrorFog(@Nullable BounceFog fog) {
        mirrorFog = fog;
    }

    /**
     * Composes some components of the first level, before any fog; the films that are not composed become black. Parameters as for {@link
     * #composeFilms}.
     */
    public void composeComponents(Set<LightComponent> components, TileLevel top, BitSet films, FilmColors @Nullable [] images,
            FilmColors to) {
        to.clear(mixer.films());
        compose(components, top, films, images, to);
    }

    private void compose(Set<LightComponent> components, TileLevel top, BitSet films, FilmColors @Nullable [] images, FilmColors to) {
        eye.composer.setComponents(components);
        compose(eye, top, films, images, to);
        eye.composer.setComponents(EnumSet.allOf(LightComponent.class));
    }

    /** Adds what mirrors show of an earlier scene to the films of the level that was composed last. */
    public void addEarlierMirrors(TileLevel top, BounceImages earlier, FilmColors to) {
        mixer.addEarlierMirrors(top.rows(), earlier, null, eye.composer, to);
    }

    /** Composes the background of a tile in some films, where it has no row; the others become black. */
    public void composeBackground(TileLevel top, SamplePositions places, BitSet films, FilmColors to) {
        eye.composer.fillBackground(top.rows(), eye.parts, films, places, to);
        compose(EnumSet.noneOf(LightComponent.class), top, films, null, to);
    }

    /** Returns whether mirrors show an earlier scene. */
    public boolean areMirrorsOutdated() {
        return mirror != eye;
    }

    /** Returns the films of the scene that mirrors show. */
    public FilmParts mirrored() {
        return mirror.parts;
    }

    /** Returns what adds the films of a tile. */
    public FilmMixer mixer() {
        return mixer;
    }

    /** Returns the rows composed so far. */
    public long rowsComposed() {
        return rowsComposed;
    }

    /** Returns the bytes read so far. */
    long bytesRead() {
        return bytesRead;
    }

    /**
     * Composes the colors of the rays that bounce from the first level's rows, by {@link BounceKind}. Returns scratch memory, valid until the
     * next call; null if they are black.
     *
     * @param places image positions of the first level's rays
     * @param levels all levels; those along which light is seen in fog are replaced by levels that know it
     * @param films  films to compose; none is dark
     */
    public FilmColors @Nullable [] composeImages(SamplePositions places, TileLevel[] levels, BitSet films) {
        nextLevel = 1;
        return composeImages(levels, 0, mirrorFog == null ? null : mirrorFog.start(places, levels[0].rows()), 0, films);
    }

    /** @param start the level's rows as the start of bounced rays; null if these show no light in fog */
    private FilmColors @Nullable [] composeImages(TileLevel[] levels, int index, @Nullable BounceStart start, int level, BitSet films) {
        HitRows rows = levels[index].rows();
        if (level == mirror.parts.scene().picture().depth() || rows.reflectiveCount == 0) {
            return null;
        }
        FilmColors[] images = mirror.composer.backgrounds(rows, mirror.parts, films, level);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0) {
                int at = nextLevel++;
                HitRows seen = levels[at].rows();
                FilmColors[] below = composeImages(levels, at, start == null ? null : start.below(bounce, seen), level + 1, films);
                FilmColors colors = images[bounce.ordinal()];
                compose(mirror, levels[at], films, below, colors);
                if (mirrorFog != null) {
                    BounceColumns columns = mirrorFog.columns(rows, seen, bounce, mirror.materials, start, mirror.parts.lights(),
                            levels[at].fog());
                    levels[at] = levels[at].withFog(columns);
                    mirrorFog.add(rows, seen, bounce, mirror.materials, columns, mirror.parts, films, colors);
                }
            }
        }
        return images;
    }

    /**
     * Composes the films of a tile; the others become black.
     *
     * @param films  films to compose; none is dark
     * @param images colors of the rays that bounce from its rows in these films; null if they are black, or show an earlier scene
     * @param fog    fog before the rows; null in clear air
     */
    public void composeFilms(TileLevel top, SamplePositions places, BitSet films, FilmColors @Nullable [] images,
            @Nullable BounceImages earlier, @Nullable BounceImages earlierEdges, @Nullable FogTile fog, FilmColors to) {
        eye.composer.fillBackground(top.rows(), eye.parts, films, places, to);
        compose(eye, top, films, images, to);
        if (earlier != null) {
            mixer.addEarlierMirrors(top.rows(), earlier, earlierEdges, eye.composer, to);
        }
        if (fog != null) {
            fogComposer.add(fog, eye.parts, films, eye.parts.scene().world().fog(), to);
        }
    }

    private void compose(Side side, TileLevel level, BitSet films, FilmColors @Nullable [] images, FilmColors to) {
        HitRows rows = level.rows();
        if (rows.count == 0) {
            return;
        }
        side.composer.composeLevel(rows, side.parts, films, level.layers(), side.indirect(level), images, to);
        rowsComposed += rows.count;
        bytesRead += 12L * (rows.reflectiveCount + rows.clearCount) + (rows.texelRed == null ? 0 : 12L * rows.count) + 2L * rows.count;
        for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
            for (int l = side.parts.get(part).from(); l < side.parts.get(part).to(); l++) {
                LightLayer layer = level.layers()[l];
                bytesRead += layer == null || layer.litCount() == 0 ? 0 : layer.bytesReadByCompositing();
            }
        }
    }
}
