package lightning.render.trace.primitive;

import lightning.render.trace.mesh.Facet;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.Sieve;
import lightning.scene.Cutout;
import lightning.scene.TextureMap;

/** Tells where one ray after the other finds a hole in a primitive whose material is cut out. Reused; not shared between threads. */
public final class Holes implements Sieve {
    private final PrimitiveTable primitives;
    private int s;
    private TextureMap map;
    private double cutoff;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private final PictureCell cell = new PictureCell();
    private final Facet facet = new Facet();
    private final double[] uv = new double[2];

    public Holes(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Takes a primitive that has holes and a ray. */
    public Holes enter(int of, double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        Cutout cutout = primitives.cutout(of);
        s = of;
        map = cutout.cutout().orElseThrow();
        cutoff = cutout.cutoff();
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        return this;
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
        return cell.red() < cutoff;
    }
}
