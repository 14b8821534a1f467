package lightning.trace.primitive;

import lightning.scene.Cutout;
import lightning.scene.TextureMap;
import lightning.trace.mesh.Facet;
import lightning.trace.mesh.MeshSolid;
import lightning.trace.mesh.Sieve;

/** Tells where one ray finds a hole in a primitive whose material is cut out. */
public final class Holes implements Sieve {
    private final PrimitiveTable primitives;
    private final int s;
    private final TextureMap map;
    private final double cutoff;
    private final double ox;
    private final double oy;
    private final double oz;
    private final double dx;
    private final double dy;
    private final double dz;
    private final PictureCell cell = new PictureCell();
    private final Facet facet = new Facet();
    private final double[] uv = new double[2];
    private final float[] there = new float[3];

    /** @param cutout of primitive {@code s}; it cuts */
    Holes(PrimitiveTable primitives, int s, Cutout cutout, double ox, double oy, double oz, double dx, double dy, double dz) {
        this.primitives = primitives;
        this.s = s;
        map = cutout.cutout().orElseThrow();
        cutoff = cutout.cutoff();
        this.ox = ox;
        this.oy = oy;
        this.oz = oz;
        this.dx = dx;
        this.dy = dy;
        this.dz = dz;
    }

    @Override
    public boolean passes(int part, double t) {
        double x = ox + t * dx;
        double y = oy + t * dy;
        double z = oz + t * dz;
        double[] m = primitives.data;
        int i = primitives.at[s];
        double ownX = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        double ownY = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        double ownZ = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).form().coordinates(m, i, ownX, ownY, ownZ, uv);
        } else {
            facet.at(mesh.mesh(), part, ownX, ownY, ownZ);
            uv[0] = facet.coordinate(0);
            uv[1] = facet.coordinate(1);
        }
        cell.at(map, uv[0], uv[1]);
        cell.color(there);
        return there[0] < cutoff;
    }
}
