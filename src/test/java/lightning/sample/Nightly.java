package lightning.sample;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;

/**
 * Marks tests that run in {@code mvn verify -Pnightly} only: tests that wait for timeouts, and long tests of a subject that faster tests
 * cover as well. The test's Javadoc names these. A test needs no {@link Slow} in addition.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Tag("nightly")
@net.jqwik.api.Tag("nightly")
public @interface Nightly {}
