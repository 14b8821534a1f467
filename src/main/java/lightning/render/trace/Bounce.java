package lightning.render.trace;

/** How a ray goes on from a row that it met. */
public enum Bounce {
    /** Mirrored, from every row of a material that mirrors or is clear. */
    MIRRORED {
        @Override
        public int rows(HitRows from) {
            return from.reflective;
        }

        @Override
        public boolean direct(HitRows from, int row, MaterialTable materials, double[] to) {
            SurfacePoint.mirror(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row], to);
            return true;
        }

        @Override
        float[] x(HitRows from) {
            return from.px;
        }

        @Override
        float[] y(HitRows from) {
            return from.py;
        }

        @Override
        float[] z(HitRows from) {
            return from.pz;
        }
    },
    /** Refracted, from every row of a clear material where the surface does not mirror all. */
    REFRACTED {
        @Override
        public int rows(HitRows from) {
            return from.clear;
        }

        @Override
        public boolean direct(HitRows from, int row, MaterialTable materials, double[] to) {
            return Refraction.direct(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row],
                    Refraction.eta(materials.clarity(from.material(row)), from.isInside(row)), to);
        }

        @Override
        float[] x(HitRows from) {
            return from.behindX;
        }

        @Override
        float[] y(HitRows from) {
            return from.behindY;
        }

        @Override
        float[] z(HitRows from) {
            return from.behindZ;
        }
    };

    /** How many rows of a level, the first ones, rays may go on from in this way. */
    public abstract int rows(HitRows from);

    /**
     * Writes the direction of the ray that goes on from a row, of length 1.
     *
     * @param to gets x, y, z, {@code double[3]}
     * @return whether a ray goes on; else nothing is written
     */
    public abstract boolean direct(HitRows from, int row, MaterialTable materials, double[] to);

    /** Where rays leave from. */
    abstract float[] x(HitRows from);

    abstract float[] y(HitRows from);

    abstract float[] z(HitRows from);
}
