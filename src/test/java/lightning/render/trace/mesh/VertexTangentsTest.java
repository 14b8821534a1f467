package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;

/** Tests the tangents of vertices of a tube along y with a seam. */
class VertexTangentsTest {
    private static final int SIDES = 8;

    /** Returns a tube whose u grows around it, or back again on its other half, and whose normals point outward. */
    private static Mesh tube(boolean isMirrored) {
        float[] positions = new float[6 * (SIDES + 1)];
        float[] normals = new float[positions.length];
        float[] uv = new float[4 * (SIDES + 1)];
        int[] triangles = new int[6 * SIDES];
        for (int i = 0; i <= SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            for (int top = 0; top < 2; top++) {
                int v = 2 * i + top;
                positions[3 * v] = normals[3 * v] = (float) Math.sin(angle);
                positions[3 * v + 1] = top;
                positions[3 * v + 2] = normals[3 * v + 2] = (float) Math.cos(angle);
                uv[2 * v] = isMirrored && i > SIDES / 2 ? SIDES - i : i;
                uv[2 * v + 1] = top;
            }
        }
        for (int i = 0; i < SIDES; i++) {
            int[] corners = {2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1};
            System.arraycopy(corners, 0, triangles, 6 * i, 6);
        }
        return new Mesh(positions, triangles, normals, uv, null);
    }

    @Test
    void tube_hasTangentsAroundItAlsoAtTheSeam() {
        float[] tangents = VertexTangents.of(tube(false), 2);
        for (int i = 0; i <= SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            assertThat((double) tangents[6 * i]).as("x at %d", i).isCloseTo(Math.cos(angle), within(1e-6));
            assertThat((double) tangents[6 * i + 1]).as("y at %d", i).isCloseTo(0, within(1e-6));
            assertThat((double) tangents[6 * i + 2]).as("z at %d", i).isCloseTo(-Math.sin(angle), within(1e-6));
        }
    }

    @Test
    void oppositeDirectionsAtASeam_doNotMix() {
        float[] tangents = VertexTangents.of(tube(true), 2);
        // Half a step to each side of the seam at x = 0, z = 1.
        double half = Math.PI / SIDES;
        assertThat((double) tangents[0]).isCloseTo(Math.cos(half), within(1e-6));
        assertThat((double) tangents[6 * SIDES]).isCloseTo(-Math.cos(half), within(1e-6));
    }
}
