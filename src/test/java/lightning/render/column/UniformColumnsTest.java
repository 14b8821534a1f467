package lightning.render.column;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class UniformColumnsTest {
    private static float[] many(float value) {
        float[] column = new float[ElementType.FLOAT.length(1000)];
        Arrays.fill(column, value);
        return column;
    }

    @Test
    void columnsOfOneValue_areOne() {
        float[] shared = UniformColumns.shared(many(3.5f), 1000);
        assertThat(UniformColumns.shared(many(3.5f), 900)).isSameAs(shared).containsOnly(3.5f).hasSizeGreaterThan(1024);
    }

    @Test
    void columnOfTwoValues_staysItsOwn() {
        float[] column = many(3.5f);
        column[999] = 4;
        assertThat(UniformColumns.shared(column, 1000)).isSameAs(column);
    }

    @Test
    void whatStandsBehindTheLastRow_doesNotCount() {
        float[] column = many(3.5f);
        column[999] = 4;
        assertThat(UniformColumns.shared(column, 999)).isSameAs(UniformColumns.shared(many(3.5f), 1000));
    }

    @Test
    void zerosOfBothSigns_areTwoValues() {
        float[] column = many(0);
        column[3] = -0f;
        assertThat(UniformColumns.shared(column, 1000)).isSameAs(column);
        assertThat(UniformColumns.shared(many(-0f), 1000)).isNotSameAs(UniformColumns.shared(many(0), 1000));
    }

    @Test
    void sharedColumns_areCountedWithNoRows() {
        assertThat(ElementType.FLOAT.bytes(UniformColumns.shared(many(3.5f), 1000))).isZero();
    }

    @Test
    void fewRows_haveColumnsOfTheirOwn() {
        UniformColumns.shared(many(7.25f), 1000);
        float[] few = new float[ElementType.FLOAT.length(20)];
        Arrays.fill(few, 7.25f);
        assertThat(UniformColumns.shared(few, 20)).isSameAs(few);
    }
}
