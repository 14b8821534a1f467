package lightning.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.cache.PixelCache;
import lightning.cache.TileLevel;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.Reflections;
import lightning.relight.tile.MirrorStorage;
import lightning.relight.tile.Options;
import lightning.sample.Session;
import lightning.scene.Scene;
import lightning.shading.LightRows;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.work.Progress;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Whatever edits led to it, a cache has the rows and columns that a first pass gives: nothing piles up. */
class RowOrderTest {

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void editedCaches_haveTheRowsOfAFirstPass(@ForAll("sessions") Session session) {
        Options options = new Options(Accuracy.EXACT, Reflections.CURRENT, MirrorStorage.FULL_ROWS, 1);
        try (Renderer edited = new Renderer(options); Renderer fresh = new Renderer(options)) {
            for (Scene scene : session.scenes()) {
                edited.render(scene, Progress.NONE);
            }
            fresh.render(session.scenes().getLast(), Progress.NONE);
            PixelCache actual = edited.cache();
            PixelCache expected = fresh.cache();
            assertThat(actual.all()).hasSameSizeAs(expected.all());
            for (int t = 0; t < expected.all().size(); t++) {
                TileLevel[] levels = expected.all().get(t).levels;
                TileLevel[] known = actual.all().get(t).levels;
                assertThat(known).hasSameSizeAs(levels);
                for (int k = 0; k < levels.length; k++) {
                    assertSame(known[k].rows(), levels[k].rows(), expected.geometry().materials());
                    assertSameColumns(known[k], levels[k]);
                }
            }
        }
    }

    private static void assertSame(HitRows actual, HitRows expected, MaterialTable materials) {
        assertThat(actual.count).isEqualTo(expected.count);
        assertThat(actual.reflective).isEqualTo(expected.reflective);
        assertThat(actual.runs).isEqualTo(expected.runs);
        assertThat(actual.texelRed == null).isEqualTo(expected.texelRed == null);
        for (int r = 0; r < expected.runs; r++) {
            assertThat(actual.runMaterial[r]).isEqualTo(expected.runMaterial[r]);
            assertThat(actual.runEnd[r]).isEqualTo(expected.runEnd[r]);
            for (int i = expected.runStart(r); i < expected.runEnd[r]; i++) {
                assertThat(actual.parent[i]).isEqualTo(expected.parent[i]);
                assertThat(actual.code == null ? 0 : actual.code[i]).isEqualTo(expected.code == null ? 0 : expected.code[i]);
                assertThat(new float[] {actual.px[i], actual.py[i], actual.pz[i], actual.nx[i], actual.ny[i], actual.nz[i],
                    actual.vx[i], actual.vy[i], actual.vz[i]}).containsExactly(expected.px[i], expected.py[i], expected.pz[i],
                            expected.nx[i], expected.ny[i], expected.nz[i], expected.vx[i], expected.vy[i], expected.vz[i]);
                if (materials.isTextured(expected.runMaterial[r])) {
                    assertThat(new float[] {actual.texelRed[i], actual.texelGreen[i], actual.texelBlue[i]})
                            .containsExactly(expected.texelRed[i], expected.texelGreen[i], expected.texelBlue[i]);
                }
            }
        }
    }

    /** Of lights that shine; the layers of others wait. */
    private static void assertSameColumns(TileLevel actual, TileLevel expected) {
        for (int l = 0; l < expected.layers().length; l++) {
            if (expected.layers()[l] instanceof LightRows e && actual.layers()[l] instanceof LightRows a) {
                assertThat(a.lit).isEqualTo(e.lit);
                assertThat(a.specular == null).as("specular column").isEqualTo(e.specular == null);
            }
        }
    }
}
