package lightning.format.mesh.obj;

import lightning.format.mesh.FloatList;

/** Vertex data that face corners reference. */
final class ObjVertexData {
    /** x, y, z. */
    final FloatList positions = new FloatList();
    /** u, v. */
    final FloatList coordinates = new FloatList();
    /** x, y, z, not normalized. */
    final FloatList normals = new FloatList();
    /** Linear red, green, blue of the positions, white for those before the first color; empty if there are none. */
    final FloatList colors = new FloatList();

    int positionCount() {
        return positions.size() / 3;
    }

    int coordinateCount() {
        return coordinates.size() / 2;
    }

    int normalCount() {
        return normals.size() / 3;
    }

    /** Sets missing colors to white. */
    void padColors() {
        while (colors.size() < positions.size()) {
            colors.add(1);
        }
    }
}
