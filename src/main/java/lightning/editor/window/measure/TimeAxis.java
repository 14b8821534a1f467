package lightning.editor.window.measure;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.chart.ValueAxis;
import lightning.editor.window.model.StatusText;

/** Logarithmic horizontal axis of times in milliseconds, with ticks at 1, 2 and 5 in each decade. */
final class TimeAxis extends ValueAxis<Number> {
    private static final int[] STEPS = {1, 2, 5};

    TimeAxis() {
        super(1, 10);
        setAnimated(false);
        setMinorTickVisible(false);
    }

    /** Bounds of the axis, milliseconds. */
    private record Bounds(double lower, double upper) {}

    @Override
    protected Object getRange() {
        return new Bounds(getLowerBound(), getUpperBound());
    }

    @Override
    protected void setRange(Object range, boolean animate) {
        Bounds bounds = (Bounds) range;
        setLowerBound(bounds.lower);
        setUpperBound(bounds.upper);
        currentLowerBound.set(bounds.lower);
        setScale(calculateNewScale(getWidth(), bounds.lower, bounds.upper));
    }

    @Override
    protected List<Number> calculateTickValues(double length, Object range) {
        Bounds bounds = (Bounds) range;
        List<Number> values = new ArrayList<>();
        for (int decade = (int) Math.floor(Math.log10(bounds.lower)); decade <= Math.log10(bounds.upper); decade++) {
            for (int step : STEPS) {
                double value = step * Math.pow(10, decade);
                if (value >= bounds.lower && value <= bounds.upper) {
                    values.add(value);
                }
            }
        }
        return values;
    }

    @Override
    protected List<Number> calculateMinorTickMarks() {
        return List.of();
    }

    @Override
    protected String getTickMarkLabel(Number value) {
        return StatusText.time(value.doubleValue());
    }

    @Override
    public double getDisplayPosition(Number value) {
        return getWidth() * Math.log(value.doubleValue() / getLowerBound()) / Math.log(getUpperBound() / getLowerBound());
    }

    @Override
    public Number getValueForDisplay(double position) {
        return getLowerBound() * Math.pow(getUpperBound() / getLowerBound(), position / getWidth());
    }

    @Override
    public double getZeroPosition() {
        return 0;
    }
}
