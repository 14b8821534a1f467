package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.gather.GatherRays;
import lightning.render.image.Film;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.MaterialUpdate;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.FilmSum;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.FilmMixer;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.FogLookup;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.fog.PictureFog;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.GatherSettings;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Builds and updates cached tiles with one engine. Holds scratch memory: use one instance per thread. */
final class TileWorker {
    private final RenderJob job;
    private final Engine engine;
    private final Tracer tracer;
    private final LevelWorker eyeWorker;
    /** True if rows store their owner shapes. */
    private final boolean needsOwners;
    /** True if tiles keep the films of pixel centers. */
    private final boolean keepsFilms;
    /** Created on first use. */
    private @Nullable LevelWorker mirrorWorker;
    /** Created on first use. */
    private @Nullable BounceLevels bounceLevels;
    /** Created on first use. */
    private @Nullable FogLookup fogLookup;
    private final TileRecomposer recomposer;
    /** Composes the colors by which edges are detected where films contain weights; created on first use. */
    private @Nullable TileRecomposer edgeRecomposer;
    /** Films composed last. */
    private final FilmColors films = new FilmColors();
    private final FilmColors edgeFilms = new FilmColors();
    /** Films that are not dark. */
    private final BitSet shining;
    /** Films that changed with the last tile or block, and those of them that were composed. */
    private BitSet changed = new BitSet();
    private BitSet composed = new BitSet();
    private long eyeRays;
    private long filmBytes;

    TileWorker(RenderJob job, Engine engine) {
        this.job = job;
        this.engine = engine;
        tracer = engine.tracer(job.target().geometry());
        eyeWorker = new LevelWorker(job, job.target(), engine, tracer);
        needsOwners = job.needsOwners();
        keepsFilms = job.keepsFilms();
        shining = job.target().parts().shining();
        recomposer = recomposer(job.target().parts(), job.mirrorTarget().parts(), false);
    }

    /** @param isForEdges whether films are those for edges */
    private TileRecomposer recomposer(FilmParts parts, FilmParts mirrored, boolean isForEdges) {
        var shown = new TileRecomposer.Shown(parts, job.target().geometry().materials(), light(job.target().indirect(), isForEdges));
        TileRecomposer created = new TileRecomposer(shown, parts == mirrored ? shown
                : new TileRecomposer.Shown(mirrored, job.mirrorTarget().geometry().materials(),
                        light(job.mirrorTarget().indirect(), isForEdges)),
                engine, job.options().view(), job.faded());
        created.setMirrorFog(BounceFog.of(job.mirrorTarget().scene(), job.bounceFog()));
        return created;
    }

    private static float @Nullable [] @Nullable [][] light(@Nullable IndirectLight indirect, boolean isForEdges) {
        return indirect == null ? null : isForEdges ? indirect.edgeLight() : indirect.light();
    }

    private LevelWorker mirrorWorker() {
        if (mirrorWorker == null) {
            mirrorWorker = job.mirrorTarget() == job.target() ? eyeWorker : new LevelWorker(job, job.mirrorTarget(), engine, tracer);
        }
        return mirrorWorker;
    }

    private BounceLevels bounceLevels() {
        bounceLevels = bounceLevels == null ? new BounceLevels(job, mirrorWorker()) : bounceLevels;
        return bounceLevels;
    }

    /** Returns the number of rays cast since the start. */
    long rayCount() {
        return eyeRays + (bounceLevels == null ? 0 : bounceLevels.rayCount()) + eyeWorker.shadowRayCount()
                + (mirrorWorker == null || mirrorWorker == eyeWorker ? 0 : mirrorWorker.shadowRayCount());
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        WorkCounts work = new WorkCounts(eyeWorker.rowsTouched(), recomposer.rowsComposed(),
                eyeWorker.bytesMoved() + recomposer.bytesRead() + mixer().bytesMoved() + filmBytes,
                new RayCounts(eyeRays, bounceLevels == null ? 0 : bounceLevels.rayCount(), GatherRays.NONE, eyeWorker.shadowRays()));
        return mirrorWorker == null || mirrorWorker == eyeWorker ? work
                : work.plus(new WorkCounts(mirrorWorker.rowsTouched(), 0, mirrorWorker.bytesMoved(),
                        RayCounts.ofShadows(mirrorWorker.shadowRays())));
    }

    double minFalloff() {
        return eyeWorker.minFalloff();
    }

    /** Traces the centers of a tile's pixels into a new cached tile; null if the work was canceled. */
    @Nullable
    CachedTile firstPass(int tile) {
        int x0 = tile % job.tilesX() * Film.TILE_SIZE;
        int y0 = tile / job.tilesX() * Film.TILE_SIZE;
        eyeRays += (long) Math.min(Film.TILE_SIZE, job.scene().picture().width() - x0)
                * Math.min(Film.TILE_SIZE, job.scene().picture().height() - y0);
        return buildTraced(SamplePositions.centers(x0, y0),
                eyeWorker.visibility().traceEyeRays(x0, y0, Film.TILE_SIZE, allocator(false)), job.detectsEdges(), false);
    }

    /**
     * Traces finer samples; null if the work was canceled.
     *
     * @param detectEdges true if their colors decide about further samples
     */
    @Nullable
    CachedTile traceSamples(SamplePositions places, boolean detectEdges) {
        eyeRays += places.count();
        return buildTraced(places, eyeWorker.visibility().traceSamples(places, allocator(true)), detectEdges, true);
    }

    /** Returns the films in which the last samples differ from before. */
    BitSet changedFilms() {
        return changed;
    }

    /** Returns those of the changed films that were composed, with films of earlier mirrors. */
    BitSet composedFilms() {
        return composed;
    }

    /** Returns what adds films. */
    FilmMixer mixer() {
        return recomposer.mixer();
    }

    /** Returns the films of the last samples, as far as they were composed; valid until the next call. */
    FilmColors films() {
        return films;
    }

    private @Nullable CachedTile buildTraced(SamplePositions places, HitRows rows, boolean detectEdges, boolean fine) {
        TileLevel top = eyeWorker.withWeights(eyeWorker.lightLevel(rows));
        BounceLevels.TracedLevels below =
                top.rows().reflectiveCount == 0 ? BounceLevels.TracedLevels.only(top, true)
                        : bounceLevels().traceAll(top, new int[0][]);
        if (job.progress().isCanceled()) {
            return null;
        }
        return buildTile(places, top, below, allFilms(), null, null, detectEdges, fine);
    }

    private BitSet allFilms() {
        BitSet all = new BitSet();
        all.set(0, job.target().parts().count());
        return all;
    }

    private TileVisibility.Allocator allocator(boolean fine) {
        return (count, texels, clear) -> new HitRows(count, texels, clear, fine, needsOwners);
    }

    /** Updates the centers of a tile's pixels as planned; null if the work was canceled. */
    @Nullable
    CachedTile relight(int tile, CachedTile old) {
        SamplePositions places = SamplePositions.centers(tile % job.tilesX() * Film.TILE_SIZE, tile / job.tilesX() * Film.TILE_SIZE);
        if (job.onlyReweights()) {
            return buildTile(places, old.levels()[0], bounceLevels().keep(old), new BitSet(), old, old.fog(), job.detectsEdges(),
                    false);
        }
        BitSet retraced = changedRays(places);
        if (!LevelWorker.isWorthUpdating(retraced, places.count())) {
            return firstPass(tile);
        }
        return relight(places, old, old.films(), retraced, job.detectsEdges(), false);
    }

    /** Returns the sample positions whose rays may have another hit than before. */
    private BitSet changedRays(SamplePositions places) {
        return job.shapeChange().isEmpty() ? new BitSet()
                : eyeWorker.visibility().eyeRaysThroughBoxes(places, job.shapeChange().visibleChanges());
    }

    /** Returns the hits of camera rays through some sample positions. */
    private HitRows eyeHits(SamplePositions places) {
        if (places.pixels() != null) {
            eyeRays += places.count();
            return eyeWorker.visibility().traceSamples(places, allocator(true));
        }
        eyeRays += (long) Math.min(Film.TILE_SIZE, job.scene().picture().width() - places.x0())
                * Math.min(Film.TILE_SIZE, job.scene().picture().height() - places.y0());
        return eyeWorker.visibility().traceEyeRays(places.x0(), places.y0(), Film.TILE_SIZE, allocator(false));
    }

    /** Adds, remaps or removes the owner shapes of a tile's rows, depending on whether a light needs them. */
    private CachedTile updateOwners(SamplePositions places, CachedTile old) {
        boolean known = old.levels()[0].rows().owner != null;
        return !needsOwners && !known || needsOwners && known && job.shapeChange().hasSameIndices() ? old
                : new CachedTile(needsOwners ? known ? reindexOwners(old) : withOwners(places, old) : withoutOwners(old), old.hitShapes(),
                        old.images(), old.film(), old.films(), old.edges(), old.fog());
    }

    /** Traces rays again to find owner shapes; keeps rows and layers. */
    private TileLevel[] withOwners(SamplePositions places, CachedTile old) {
        TileLevel top = old.levels()[0].withOwner(eyeHits(places).ownersFor(old.levels()[0].rows()));
        return bounceLevels().retraceHits(old, top, (level, retracedRows) -> level.withOwner(retracedRows.ownersFor(level.rows())));
    }

    private TileLevel[] reindexOwners(CachedTile old) {
        return Arrays.stream(old.levels()).map(level -> level.withOwner(job.shapeChange().mapIndices(requireNonNull(level.rows().owner))))
                .toArray(TileLevel[]::new);
    }

    private static TileLevel[] withoutOwners(CachedTile old) {
        return Arrays.stream(old.levels()).map(level -> level.withOwner(null)).toArray(TileLevel[]::new);
    }

    /**
     * Updates finer samples as planned; null if the work was canceled.
     *
     * @param known means of the samples in each film; null if unknown
     */
    @Nullable
    CachedTile relight(SamplePositions places, CachedTile old, @Nullable StoredFilms known, boolean detectEdges) {
        BitSet retraced = changedRays(places);
        return LevelWorker.isWorthUpdating(retraced, places.count()) ? relight(places, old, known, retraced, detectEdges, true)
                : traceSamples(places, detectEdges);
    }

    /**
     * @param films       known films; null for none
     * @param retraced    sample positions whose rays are traced again
     * @param detectEdges true if edges are detected in these rows
     * @param fine        true if they are finer samples
     */
    private @Nullable CachedTile relight(SamplePositions places, CachedTile previous, @Nullable StoredFilms films, BitSet retraced,
            boolean detectEdges, boolean fine) {
        CachedTile old = updateOwners(places, previous);
        TileLevel known = old.levels()[0];
        LevelPlan plan = requireNonNull(job.topPlan());
        MaterialUpdate materials = plan.materials();
        RowSplice order = !retraced.isEmpty() || materials.mirroringChanged().intersects(known.rows())
                ? RowSplice.sort(known.rows(), retraced, job.target().geometry().materials()) : null;
        TileLevel sorted = order == null ? known : eyeWorker.reorder(order, known);
        sorted = eyeWorker.retexture(sorted, places, plan);
        TileLevel top = eyeWorker.update(sorted, plan);
        if (!retraced.isEmpty() && !job.progress().isCanceled()) {
            TileLevel added =
                    eyeWorker.lightLevel(eyeWorker.visibility().traceEyeRays(places, retraced, allocator(fine)));
            eyeRays += retraced.cardinality();
            RowSplice all = RowSplice.join(Film.TILE_PIXELS, top.rows(), added.rows(), job.target().geometry().materials());
            top = eyeWorker.join(all, top, added);
            order = requireNonNull(order).andThen(all);
        }
        if (job.progress().isCanceled()) {
            return null;
        }
        top = eyeWorker.withWeights(top);
        boolean knowsEdges = !detectEdges || old.edges() != null;
        // Films that contain mirrors, and colors for edges that were never composed, need levels, which may not be stored.
        boolean reusesBounces = job.mirrorPlan() == null && order == null
                && (job.storesMirrorRows() || top.rows().reflectiveCount == 0 || knowsEdges && job.areMirrorsOutdated());
        BounceLevels.TracedLevels below = reusesBounces ? bounceLevels().keep(old)
                : updateLower(old, top, order);
        if (job.progress().isCanceled()) {
            return null;
        }
        BitSet changes = changes(old, top, below, order != null);
        addUnknown(films, changes, fine);
        return buildTile(places, top, below, changes, old, order == null ? old.fog() : null, detectEdges, fine);
    }

    /** Returns the films that change, apart from their fog before the first level. @param isReordered whether the first level has other rows */
    private BitSet changes(CachedTile old, TileLevel top, BounceLevels.TracedLevels below, boolean isReordered) {
        TileLevel[] levels = below.allLevels(top);
        boolean changesAll = isReordered || below.isChanged() || job.changesBounceFog() || job.indirectChange().isAll()
                || job.mirroredIndirectChange().isAll() || job.togglesMirrors() || changesEarlierMirrors();
        // What earlier mirrors show is a film of its own.
        int count = job.areMirrorsOutdated() ? 1 : levels.length;
        changesAll |= count > 1 && levels.length != old.levels().length;
        for (int i = 0; i < count && !changesAll; i++) {
            changesAll = i >= old.levels().length || levels[i].rows() != old.levels()[i].rows()
                    || levels[i].weights() != old.levels()[i].weights()
                    || plan(i).materials().colorChanged().intersects(levels[i].rows());
        }
        if (changesAll) {
            return allFilms();
        }
        BitSet changes = (BitSet) job.films().changed().clone();
        for (int i = 0; i < count; i++) {
            // Levels below that no plan updates are kept, and may have the layers of an earlier scene.
            if (i == 0 || job.mirrorPlan() != null) {
                plan(i).addChanged(job.target().parts(), old.levels()[i], levels[i], changes);
            }
            (i == 0 ? job.indirectChange() : job.mirroredIndirectChange()).addChanged(levels[i].weights(), changes);
        }
        return changes;
    }

    /** Returns whether mirrors show another earlier scene than in the last picture. */
    private boolean changesEarlierMirrors() {
        return job.areMirrorsOutdated() && job.mirrorPlan() != null;
    }

    /** Returns whether any film that has another weight may show something here. None changes. @param levels levels of the scene */
    private boolean isAnyShown(CachedTile old, TileLevel[] levels) {
        BitSet reweighted = job.films().reweighted();
        for (int film = reweighted.nextSetBit(0); film >= 0; film = reweighted.nextSetBit(film + 1)) {
            int origin = job.films().origin()[film];
            FilmPart its = job.target().parts().get(film);
            if (origin != film || its.kind() != FilmPart.Kind.LIGHT || (old.films() == null ? isShown(its, levels)
                    : old.films().get(film) != null || !old.films().known().get(film))) {
                return true;
            }
        }
        return false;
    }

    private boolean isShown(FilmPart its, TileLevel[] levels) {
        Light light = job.scene().lights().get(its.index());
        if (!job.storesMirrorRows() || GatherSettings.of(job.scene()).isPresent() || job.scene().world().fog().isPresent()
                || light.area().visibility() != FaceVisibility.HIDDEN
                || job.target().geometry().materials().bulbsOf(light.name()) != null) {
            return true;
        }
        return Arrays.stream(levels).anyMatch(level -> level.rows().count > 0 && LightLayer.isLit(level.layers()[its.from()]));
    }

    /** Adds films that are not dark and not known. */
    private void addUnknown(@Nullable StoredFilms known, BitSet changes, boolean fine) {
        if (known == null && fine) {
            changes.or(allFilms());
        }
        for (int film = shining.nextSetBit(0); film >= 0; film = shining.nextSetBit(film + 1)) {
            int origin = job.films().origin()[film];
            changes.set(film, changes.get(film) || known != null && (origin < 0 || !known.known().get(origin)));
        }
    }

    private LevelPlan plan(int level) {
        return requireNonNull(level == 0 || job.mirrorPlan() == null ? job.topPlan() : job.mirrorPlan());
    }

    /**
     * Composes the films that change, adds all, and builds the tile.
     *
     * @param changes   films that change, apart from their fog
     * @param old       the last tile; null for none
     * @param fogBefore fog before the same surfaces in the last picture; null for none
     * @param detectEdges true if edges are detected in these rows
     * @param fine      true if the rows are finer samples, whose colors are stored only to bound errors
     */
    private CachedTile buildTile(SamplePositions places, TileLevel top, BounceLevels.TracedLevels below, BitSet changes,
            @Nullable CachedTile old, @Nullable FogTile fogBefore, boolean detectEdges, boolean fine) {
        FogTile fog = job.fog() == null ? null : fogLookup(job.fog()).tile(places, top.rows(), fogBefore);
        addChangedFog(fogBefore, fog, changes);
        boolean isExact = job.options().method().isExact();
        boolean stores = fine ? isExact : keepsFilms;
        boolean knowsEdges = !detectEdges || old != null && old.edges() != null;
        boolean reweights = !changes.isEmpty() || job.films().reweights()
                && (old == null || isAnyShown(old, job.areMirrorsOutdated() ? new TileLevel[] {top} : below.allLevels(top)));
        // Images without rows have weights, and mirrors may show them later.
        boolean changesColors = !changes.isEmpty()
                || reweights && (!fine || !job.storesMirrorRows() && top.rows().reflectiveCount > 0);
        boolean changesEdges = detectEdges && (!changes.isEmpty() || !knowsEdges || reweights && job.films().changesEdges());
        changed = changes;
        // Colors of single samples are no sum of stored films.
        boolean composesAll = !stores && changesColors || old == null || !fine && old.films() == null || fine && changesEdges;
        composed = new BitSet();
        TileLevel[] levels = below.levels().clone();
        levels[0] = top;
        BounceImages images = old == null ? null : old.images();
        BounceImages edgeImages = old == null || old.edges() == null ? null : old.edges().images();
        if (changesColors || changesEdges) {
            changed = composesAll ? allFilms() : changes;
            composed = (BitSet) changed.clone();
            composed.and(shining);
            boolean showsEarlier = job.areMirrorsOutdated() && top.rows().reflectiveCount > 0;
            FilmColors[] bounced = null;
            if (top.rows().reflectiveCount > 0 && (!showsEarlier && !composed.isEmpty()
                    || showsEarlier && (images == null || below.isChanged() || changesEarlierMirrors()
                            || fine && job.togglesMirrors() && job.storesMirrorRows() || detectEdges && isExact && edgeImages == null))) {
                TileLevel[] all = below.allLevels(top);
                bounced = recomposer.composeImages(places, all, showsEarlier ? job.mirrorTarget().parts().shining() : composed);
                System.arraycopy(all, 0, levels, 0, levels.length);
                if (job.storesImages() && bounced != null) {
                    images = recomposer.mixer().images(top.rows(), bounced, false).compact(top.rows());
                    edgeImages = detectEdges && isExact ? recomposer.mixer().images(top.rows(), bounced, true).compact(top.rows()) : null;
                }
            }
            if (composed.isEmpty() && !showsEarlier) {
                films.clear(job.target().parts().count(), places.count());
            } else {
                recomposer.composeFilms(top, places, composed, showsEarlier ? null : bounced, showsEarlier ? images : null,
                        showsEarlier ? edgeImages : null, fog, films);
            }
            int earlier = job.target().parts().count();
            composed.set(earlier, earlier + FilmMixer.EARLIER_FILMS, showsEarlier);
            changed = (BitSet) changed.clone();
            changed.set(earlier, earlier + FilmMixer.EARLIER_FILMS, job.areMirrorsOutdated());
        }
        StoredFilms kept = fine || !stores ? null
                : changed.isEmpty() && old != null && job.films().isSame() ? old.films()
                : StoredFilms.after(old == null ? null : old.films(), job.films().origin(), changed, composed,
                        film -> films.copy(film));
        float[][] colors = old == null ? null : old.film();
        if (changesColors && (!fine || !isExact)) {
            colors = new float[3][Film.TILE_PIXELS];
            if (kept == null) {
                recomposer.mixer().mix(films::get, colors);
                filmBytes += 12L * Film.TILE_PIXELS;
            } else {
                kept = recomposer.mixer().mix(kept, colors);
            }
        }
        EdgeColors edges = !detectEdges ? null : old == null ? null : old.edges();
        if (changesEdges) {
            FilmSum.Films all = kept == null ? films::get : kept::get;
            EdgeColors now = isExact ? new EdgeColors(recomposer.mixer().edgeColors(all, places.count()), edgeImages)
                    : weightedEdges(places, below.allLevels(top), below.isChanged() ? null : edgeImages, fog);
            edges = now.reuseIfEqual(edges);
        }
        return new CachedTile(levels, below.hitShapes(), images, colors, kept, edges, fog);
    }

    /**
     * Returns the colors for edges where films contain weights, which are not rounded: those of films without weights.
     *
     * @param earlier what mirrors show of an earlier scene; null if it is unknown
     */
    private EdgeColors weightedEdges(SamplePositions places, TileLevel[] levels, @Nullable BounceImages earlier,
            @Nullable FogTile fog) {
        FilmParts parts = job.target().edgeParts();
        if (edgeRecomposer == null) {
            edgeRecomposer = recomposer(parts, job.mirrorTarget().edgeParts(), true);
        }
        HitRows rows = levels[0].rows();
        TileLevel[] terms = rows.reflectiveCount == 0 ? levels : bounceLevels().withTerms(levels);
        terms[0] = eyeWorker.withTerms(levels[0]);
        boolean showsEarlier = job.areMirrorsOutdated() && rows.reflectiveCount > 0;
        BounceImages images = showsEarlier ? earlier : null;
        FilmColors[] bounced = null;
        if (rows.reflectiveCount > 0 && images == null) {
            bounced = edgeRecomposer.composeImages(places, terms, job.mirrorTarget().edgeParts().shining());
            images = bounced != null && (showsEarlier || job.storesImages())
                    ? edgeRecomposer.mixer().images(rows, bounced, true).compact(rows) : null;
        }
        edgeRecomposer.composeFilms(terms[0], places, parts.shining(), showsEarlier ? null : bounced, showsEarlier ? images : null,
                showsEarlier ? images : null, fog, edgeFilms);
        return new EdgeColors(edgeRecomposer.mixer().edgeColors(edgeFilms::get, places.count()), images);
    }

    /** Adds the films whose fog before the first level changes. */
    private void addChangedFog(@Nullable FogTile before, @Nullable FogTile now, BitSet changes) {
        if (before == now) {
            return;
        }
        if (before == null || now == null || before.transmittance() != now.transmittance()) {
            changes.set(0, job.target().parts().count());
            return;
        }
        FilmParts parts = job.target().parts();
        for (int part = 0; part < parts.count(); part++) {
            for (int l = parts.get(part).from(); l < parts.get(part).to(); l++) {
                LayerPlan layer = requireNonNull(job.topPlan()).layers().get(l);
                boolean isSame = layer.base() != null && before.scattered()[layer.base().index()] == now.scattered()[l];
                changes.set(part, changes.get(part) || !isSame);
            }
        }
    }

    private FogLookup fogLookup(PictureFog fog) {
        fogLookup = fogLookup == null ? new FogLookup(fog, job.target().lights()) : fogLookup;
        return fogLookup;
    }

    /** @param order splice of the first level's rows; null if they are unchanged */
    private BounceLevels.TracedLevels updateLower(CachedTile old, TileLevel top, @Nullable RowSplice order) {
        if (top.rows().reflectiveCount == 0) {
            return BounceLevels.TracedLevels.only(top, old.levels()[0].rows().reflectiveCount > 0);
        }
        return bounceLevels().updateAll(old, top, order);
    }
}
