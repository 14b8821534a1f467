package lightning.sample;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;

/**
 * Marks tests that run in {@code mvn verify} but not in {@code mvn test}: tests that open a window, and tests that take about two seconds
 * or more, alone or as a class.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Tag("slow")
@net.jqwik.api.Tag("slow")
public @interface Slow {}
