package lightning.render.column;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class UniformColumnsTest {
    private static float[] uniformColumn(float value) {
        float[] column = new float[ElementType.FLOAT.length(1000)];
        Arrays.fill(column, value);
        return column;
    }

    @Test
    void equalUniformColumns_areShared() {
        float[] shared = UniformColumns.share(uniformColumn(3.5f), 1000);
        assertThat(UniformColumns.share(uniformColumn(3.5f), 900)).isSameAs(shared).containsOnly(3.5f).hasSizeGreaterThan(1024);
    }

    @Test
    void nonuniformColumn_isNotShared() {
        float[] column = uniformColumn(3.5f);
        column[999] = 4;
        assertThat(UniformColumns.share(column, 1000)).isSameAs(column);
    }

    @Test
    void valuesAfterLastRow_areIgnored() {
        float[] column = uniformColumn(3.5f);
        column[999] = 4;
        assertThat(UniformColumns.share(column, 999)).isSameAs(UniformColumns.share(uniformColumn(3.5f), 1000));
    }

    @Test
    void signedZeros_areDistinctValues() {
        float[] column = uniformColumn(0);
        column[3] = -0f;
        assertThat(UniformColumns.share(column, 1000)).isSameAs(column);
        assertThat(UniformColumns.share(uniformColumn(-0f), 1000)).isNotSameAs(UniformColumns.share(uniformColumn(0), 1000));
    }

    @Test
    void sharedColumns_countZeroBytes() {
        assertThat(ElementType.FLOAT.bytes(UniformColumns.share(uniformColumn(3.5f), 1000))).isZero();
    }

    @Test
    void smallColumns_areNotShared() {
        UniformColumns.share(uniformColumn(7.25f), 1000);
        float[] few = new float[ElementType.FLOAT.length(20)];
        Arrays.fill(few, 7.25f);
        assertThat(UniformColumns.share(few, 20)).isSameAs(few);
    }
}
