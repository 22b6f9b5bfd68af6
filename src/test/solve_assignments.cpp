// Solves the assignment problems on the standard input, each "rows columns cost cost ...", and prints each one's least
// sum.
#include <cstdio>
#include <iostream>
#include <vector>

#include <tws_core/assignment.h>

int main() {
  tws::AssignmentSolver solver;
  std::size_t rows = 0, columns = 0;
  while (std::cin >> rows >> columns) {
    std::vector<double> costs(rows * columns);
    for (double& cost : costs)
      if (!(std::cin >> cost)) return 1;
    solver.solve(costs, rows, columns);
    std::printf("%.17g\n", solver.cost());
  }
  return 0;
}
