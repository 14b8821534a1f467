package lightning.format.mesh.obj;

import lightning.format.mesh.FloatList;

/** All that the corners of faces may name. */
final class ObjVertexData {
    /** x, y, z. */
    final FloatList positions = new FloatList();
    /** u, v. */
    final FloatList coordinates = new FloatList();
    /** x, y, z, of any length. */
    final FloatList normals = new FloatList();
    /** Linear red, green, blue of the positions that have one, white of those before them; empty where none has. */
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

    /** Gives white to the positions without a color. */
    void padColors() {
        while (colors.size() < positions.size()) {
            colors.add(1);
        }
    }
}
