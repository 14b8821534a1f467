package lightning.render.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Pareto front of measured settings: those that no other setting beats in both time and error. */
public final class ParetoFront {
    private ParetoFront() {}

    /** Returns the Pareto-optimal points, fastest first. */
    public static <P> List<P> of(List<P> points, ToDoubleFunction<P> time, ToDoubleFunction<P> error) {
        List<P> front = new ArrayList<>();
        for (P p : points.stream().sorted(Comparator.comparingDouble(time).thenComparingDouble(error)).toList()) {
            if (front.isEmpty() || error.applyAsDouble(p) < error.applyAsDouble(front.getLast())) {
                front.add(p);
            }
        }
        return front;
    }
}
