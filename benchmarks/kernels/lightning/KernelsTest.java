package lightning;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import lightning.bench.mesh.RaySet;
import lightning.render.engine.KernelAgreement;
import lightning.render.engine.lanes.RayKernels;
import lightning.render.engine.lanes.ShapeKernels;
import lightning.render.shading.composition.RowKernels;
import lightning.render.trace.mesh.MeshKernels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that the kernels in benchmarks/ find their rows and rays, and agree with the scalar code; otherwise they could not be
 * measured.
 */
class KernelsTest {

    @ParameterizedTest
    @ValueSource(strings = {"bird", "balls"})
    void rowKernels_matchReference(String scene) throws Exception {
        RowKernels kernels = new RowKernels();
        kernels.scene = scene;
        kernels.prepare();
    }

    @ParameterizedTest
    @ValueSource(strings = {"bird", "balls"})
    void rayKernels_matchReference(String scene) throws Exception {
        RayKernels kernels = new RayKernels();
        kernels.scene = scene;
        kernels.prepare();
    }

    @ParameterizedTest
    @EnumSource
    void shapeKernels_matchReference(ShapeKernels.Kind kind) {
        ShapeKernels kernels = new ShapeKernels();
        kernels.kind = kind;
        kernels.prepare();
    }

    @ParameterizedTest
    @EnumSource
    void meshKernels_matchReference(RaySet.Kind kind) {
        MeshKernels kernels = new MeshKernels();
        kernels.triangles = 10_000;
        kernels.kind = kind;
        kernels.prepare();
    }

    @Test
    void singleBitDifference_isRejected() {
        KernelAgreement.requireEqual(1f, 1f, "row", 3);
        assertThatThrownBy(() -> KernelAgreement.requireEqual(1f, Math.nextUp(1f), "row", 3)).isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("row 3");
    }
}
