package lightning.format.usd;

/** Table of numbers, row by row, to which columns are added. */
final class NumberColumns {
    private final int rows;
    private int stride;
    private double[] numbers = {};

    NumberColumns(int rows) {
        this.rows = rows;
    }

    int rows() {
        return rows;
    }

    int stride() {
        return stride;
    }

    double[] numbers() {
        return numbers;
    }

    /** Adds columns; returns the first. */
    int add(float[] values) {
        return add(rows == 0 ? 0 : values.length / rows, values);
    }

    /** Adds columns; returns the first. */
    int add(int width, float[] values) {
        int first = stride;
        double[] wider = new double[rows * (stride + width)];
        for (int row = 0; row < rows; row++) {
            System.arraycopy(numbers, row * stride, wider, row * (stride + width), stride);
            for (int i = 0; i < width; i++) {
                wider[row * (stride + width) + stride + i] = values[row * width + i];
            }
        }
        numbers = wider;
        stride += width;
        return first;
    }

    /** Returns columns of a table. */
    static float[] column(double[] numbers, int stride, int first, int width) {
        float[] result = new float[stride == 0 ? 0 : numbers.length / stride * width];
        for (int i = 0; i < result.length; i++) {
            result[i] = (float) numbers[i / width * stride + first + i % width];
        }
        return result;
    }
}
