package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.sample.EditSession;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Tests that after any edits a cache has the rows and columns of a first pass, without leftovers. */
class RowOrderTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void editedCache_hasRowsOfFirstPass(@ForAll("sessions") EditSession session) {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1);
        try (Renderer edited = new Renderer(options); Renderer fresh = new Renderer(options)) {
            for (Scene scene : session.timedScenes()) {
                edited.render(scene, Progress.NONE);
            }
            fresh.render(edited.scene(), Progress.NONE);
            PixelCache actual = edited.cache();
            PixelCache expected = fresh.cache();
            assertThat(actual.tileCount()).isEqualTo(expected.tileCount());
            for (int t = 0; t < expected.tileCount(); t++) {
                assertSame(actual.tile(t), actual, expected.tile(t), expected);
            }
            assertThat(actual.fineCount()).isEqualTo(expected.fineCount());
            for (int t = 0; t < expected.fineCount(); t++) {
                assertSame(actual.fineTile(t).first(), actual, expected.fineTile(t).first(), expected);
                assertSame(actual.fineTile(t).rest(), actual, expected.fineTile(t).rest(), expected);
            }
        }
    }

    /** Asserts that the same pixels have samples; if also in the same blocks, that their rows are the same. */
    private static void assertSame(FineSamples known, PixelCache actual, FineSamples samples, PixelCache expected) {
        assertThat(known.pixels()).isEqualTo(samples.pixels());
        boolean sameBlocks = known.blocks().length == samples.blocks().length;
        for (int b = 0; sameBlocks && b < samples.blocks().length; b++) {
            if (Arrays.equals(known.blocks()[b].pixels(), samples.blocks()[b].pixels())) {
                assertSame(known.blocks()[b].rows(), actual, samples.blocks()[b].rows(), expected);
            }
        }
    }

    private static void assertSame(CachedTile known, PixelCache actual, CachedTile tile, PixelCache expected) {
        assertThat(known.levels()).hasSameSizeAs(tile.levels());
        int end = assertSame(known.levels(), actual.geometry().materials(), tile.levels(), expected.geometry().materials(), 0, null,
                expected.scene().picture().depth());
        assertThat(end).isEqualTo(tile.levels().length);
    }

    /**
     * Asserts that a level and all levels seen from it are as expected.
     *
     * @param above for each expected row of the level above its index among the actual rows; null for the first level
     * @param depth number of further bounces
     * @return the index after the last compared level
     */
    private static int assertSame(TileLevel[] actual, MaterialTable actualMaterials, TileLevel[] expected, MaterialTable materials, int k,
            int[] above, int depth) {
        int[] places = assertSame(actual[k].rows(), actualMaterials, expected[k].rows(), materials, above);
        assertSameColumns(actual[k], expected[k]);
        int next = k + 1;
        for (BounceKind bounce : BounceKind.values()) {
            if (depth > 0 && bounce.rowCount(expected[k].rows()) > 0) {
                next = assertSame(actual, actualMaterials, expected, materials, next, places, depth - 1);
            }
        }
        return next;
    }

    /**
     * Asserts that rows have the same materials, mirroring rows first. After an edit of shapes, material indices may differ from
     * those of a first pass, and so may the row order.
     *
     * @param above for each expected row of the level above its index among the actual rows; null for the first level
     * @return for each expected row of this level its index among the actual rows
     */
    private static int[] assertSame(HitRows actual, MaterialTable actualMaterials, HitRows expected, MaterialTable materials, int[] above) {
        assertThat(actual.count).isEqualTo(expected.count);
        assertThat(actual.reflectiveCount).isEqualTo(expected.reflectiveCount);
        assertThat(actual.clearCount).isEqualTo(expected.clearCount);
        assertThat(actual.backX == null).isEqualTo(expected.backX == null);
        assertThat(actual.runCount).isEqualTo(expected.runCount);
        assertThat(actual.texelRed == null).isEqualTo(expected.texelRed == null);
        Map<Integer, Integer> byParent = new HashMap<>();
        for (int i = 0; i < actual.count; i++) {
            byParent.put((int) actual.parent[i], i);
        }
        Material[] of = materials(actual, actualMaterials);
        int[] places = new int[expected.count];
        for (int r = 0; r < expected.runCount; r++) {
            Material material = materials.material(expected.runMaterial[r]);
            for (int i = expected.runStart(r); i < expected.runEnd[r]; i++) {
                int parent = expected.parent[i];
                int a = byParent.getOrDefault(above == null ? parent : above[parent], -1);
                assertThat(a).as("row seen from row " + parent).isNotNegative();
                places[i] = a;
                assertThat(of[a]).isEqualTo(material);
                assertThat(actual.pattern == null ? 0 : actual.pattern[a]).isEqualTo(expected.pattern == null ? 0 : expected.pattern[i]);
                assertThat(new float[] {actual.px[a], actual.py[a], actual.pz[a], actual.nx[a], actual.ny[a], actual.nz[a],
                    actual.vx[a], actual.vy[a], actual.vz[a]}).containsExactly(expected.px[i], expected.py[i], expected.pz[i],
                            expected.nx[i], expected.ny[i], expected.nz[i], expected.vx[i], expected.vy[i], expected.vz[i]);
                if (materials.isClear(expected.runMaterial[r])) {
                    assertThat(new float[] {actual.backX[a], actual.backY[a], actual.backZ[a], actual.insideDistance[a]})
                            .containsExactly(expected.backX[i], expected.backY[i], expected.backZ[i], expected.insideDistance[i]);
                }
                if (materials.isTextured(expected.runMaterial[r])) {
                    assertThat(new float[] {actual.texelRed[a], actual.texelGreen[a], actual.texelBlue[a]})
                            .containsExactly(expected.texelRed[i], expected.texelGreen[i], expected.texelBlue[i]);
                }
            }
        }
        return places;
    }

    private static Material[] materials(HitRows rows, MaterialTable materials) {
        Material[] of = new Material[rows.count];
        for (int r = 0; r < rows.runCount; r++) {
            Arrays.fill(of, rows.runStart(r), rows.runEnd[r], materials.material(rows.runMaterial[r]));
        }
        return of;
    }

    /** Compares layers of lights that shine; other layers may be outdated. */
    private static void assertSameColumns(TileLevel actual, TileLevel expected) {
        for (int l = 0; l < expected.layers().length; l++) {
            if (expected.layers()[l] instanceof LightRows e && actual.layers()[l] instanceof LightRows a) {
                assertThat(a.litCount).isEqualTo(e.litCount);
                assertThat(a.specular == null).as("specular column").isEqualTo(e.specular == null);
            }
        }
    }
}
