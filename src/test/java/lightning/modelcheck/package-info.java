/** Model checking of concurrent code: runs scenarios in many schedules and checks their assertions. */
package lightning.modelcheck;
