package lightning.base.math;

/**
 * 3 × 3 matrix for columns of three values.
 *
 * @param m {@code double[9]}, row by row
 */
public record Matrix3(double[] m) {
    // An array in a record: written once by its creator, never after.

    public static Matrix3 of(double... m) {
        return new Matrix3(m);
    }

    /** Returns the matrix times a column. */
    public double[] times(double... v) {
        return new double[] {row(0, v), row(3, v), row(6, v)};
    }

    private double row(int at, double[] v) {
        return m[at] * v[0] + m[at + 1] * v[1] + m[at + 2] * v[2];
    }

    /** Returns the matrix of the transform that applies {@code first} before this one. */
    public Matrix3 after(Matrix3 first) {
        double[] product = new double[9];
        for (int i = 0; i < 9; i++) {
            int row = i - i % 3;
            int column = i % 3;
            product[i] = m[row] * first.m[column] + m[row + 1] * first.m[3 + column] + m[row + 2] * first.m[6 + column];
        }
        return new Matrix3(product);
    }

    /** Returns this matrix with each row multiplied by a factor. */
    public Matrix3 scaleRows(double... factor) {
        double[] scaled = new double[9];
        for (int i = 0; i < 9; i++) {
            scaled[i] = m[i] * factor[i / 3];
        }
        return new Matrix3(scaled);
    }

    /** Returns this matrix with each column multiplied by a factor. */
    public Matrix3 scaleColumns(double... factor) {
        double[] scaled = new double[9];
        for (int i = 0; i < 9; i++) {
            scaled[i] = m[i] * factor[i % 3];
        }
        return new Matrix3(scaled);
    }

    /** Returns the inverse by cofactors. */
    public Matrix3 inverse() {
        double[] inverse = new double[9];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                int r1 = (row + 1) % 3;
                int r2 = (row + 2) % 3;
                int c1 = (column + 1) % 3;
                int c2 = (column + 2) % 3;
                inverse[3 * column + row] = m[3 * r1 + c1] * m[3 * r2 + c2] - m[3 * r1 + c2] * m[3 * r2 + c1];
            }
        }
        double determinant = m[0] * inverse[0] + m[1] * inverse[3] + m[2] * inverse[6];
        for (int i = 0; i < 9; i++) {
            inverse[i] /= determinant;
        }
        return new Matrix3(inverse);
    }
}
