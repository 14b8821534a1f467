package lightning.format.jen.asset;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.AbstractList;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.file.UnusableFileException;
import lightning.format.mesh.NamedMesh;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;

/** Lookup of parts of mesh files by name. */
class MeshPartsTest {
    private static final int PARTS = 1000;

    private final List<NamedMesh> meshes = IntStream.range(0, PARTS)
            .mapToObj(i -> new NamedMesh("part " + i, triangle(i)))
            .toList();
    private int steps;

    private static Mesh triangle(int x) {
        return new Mesh(new float[] {x, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}, null, null, null);
    }

    @Test
    void part_isFoundWithoutScanningOthers() throws UnusableFileException {
        var parts = new MeshParts(new AbstractList<>() {
            @Override
            public NamedMesh get(int index) {
                steps++;
                return meshes.get(index);
            }

            @Override
            public int size() {
                return PARTS;
            }
        });
        for (NamedMesh mesh : meshes) {
            assertThat(parts.part(mesh.name(), "a.glb")).isEqualTo(mesh.mesh());
        }
        assertThat(steps).isLessThanOrEqualTo(PARTS);
    }
}
